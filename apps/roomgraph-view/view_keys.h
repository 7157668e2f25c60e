#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ViewState.h"

namespace roomgraph {

/** What a key does, and another one the other way round; and what is told of it. */
struct Action {
  int key, back;                   ///< of GLFW; 0 for none
  const char *brief, *help;        ///< in a line with others, and in one of its own; or empty
  bool (*isOf)(const View& view);  ///< whether the help has it
  void (*run)(bool isForward, const View& view, ViewState& state) = nullptr;
  const char* button = nullptr;                    ///< what its button is called; null for none
  bool (*isOn)(const ViewState& state) = nullptr;  ///< of a button
};

/** All of them, in the order of the help and of the buttons. */
std::vector<Action> actions();

/** What a key asks for, null for nothing, and whether that is forward. Shift: as far as it goes. */
std::pair<const Action*, bool> actionOf(int key, bool isShifted);

/** How far a key moves a run [m], and turns it [rad]; none for other keys. Shift: a fifth of it. */
struct NudgeStep {
  Point shift;
  double turn = 0;
};
std::optional<NudgeStep> nudgeStepOf(int key, bool isShifted);

/** The keys that do something now, in one line; or all that there are to press in this view, a line
 *  each, where the state asks for them. */
std::vector<std::string> helpLines(const View& view, const ViewState& state);

}  // namespace roomgraph
