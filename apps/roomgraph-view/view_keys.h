#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ViewState.h"

namespace roomgraph {

/** What a key of GLFW asks for; none where it asks for nothing. Shift turns a direction round. */
std::optional<Wish> wishOf(int key, bool isShifted);

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
