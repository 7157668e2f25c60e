#include "view_keys.h"

#include <GLFW/glfw3.h>

#include <cmath>
#include <map>

namespace roomgraph {
namespace {

constexpr double kShift = 0.05;             // [m]
constexpr double kTurn = 0.5 * M_PI / 180;  // [rad]
constexpr double kFine = 0.2;               // of a step

bool always(const View&) { return true; }
bool hasMap(const View& view) { return view.stages.has_value(); }
bool hasPath(const View& view) { return !view.path(0).empty(); }
bool hasRuns(const View& view) { return view.comparison.runs.size() > 1; }
bool hasFaults(const View& view) { return !view.faults.empty(); }

constexpr int kShifted = 1 << 10;         // beside a key
constexpr std::size_t kToEnd = 1U << 30;  // more key frames than any run has

template <std::size_t by>
void stepBy(bool isForward, const View& view, ViewState& state) {
  stepFrames(isForward, by, view, state);
}

constexpr Action kActions[] = {
    {GLFW_KEY_B, GLFW_KEY_V, "", "B, V: next, previous break or other fault", hasFaults, stepFault},
    {GLFW_KEY_RIGHT, GLFW_KEY_LEFT, "arrows: key frame",
     "right, left: key frame on, back; up, down: ten; shift: to the end", hasPath, stepBy<1>},
    {kShifted | GLFW_KEY_RIGHT, kShifted | GLFW_KEY_LEFT, "", "", hasPath, stepBy<kToEnd>},
    {GLFW_KEY_UP, GLFW_KEY_DOWN, "", "", hasPath, stepBy<10>},
    {GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN, "", "", hasPath, stepBy<10>},
    {GLFW_KEY_SPACE, 0, "space: play", "space: play", hasPath,
     [](bool, auto& view, auto& state) { play(view, state); }, "play",
     [](auto& state) { return state.isPlaying; }},
    {GLFW_KEY_G, 0, "G: grow", "G: grow: only what was seen up to the key frame", hasPath,
     [](bool, auto&, auto& state) { state.growsMap = !state.growsMap; }, "grow",
     [](auto& state) { return state.growsMap; }},
    {GLFW_KEY_TAB, 0, "tab: run", "tab: next run", hasRuns,
     [](bool, auto& view, auto& state) { nextRun(view, state); }},
    {GLFW_KEY_O, 0, "O: other", "O: other run, to hold against it; at a break: what it shows there",
     hasRuns, [](bool, auto& view, auto& state) { nextOther(view, state); }},
    {GLFW_KEY_F, 0, "F: flicker", "F: flicker between the two", hasRuns,
     [](bool, auto& view, auto& state) { flicker(view, state); }, "flicker",
     [](auto& state) { return state.isFlickering; }},
    {GLFW_KEY_W, 0, "W: swipe", "W: swipe: one run on each side of a line", hasRuns,
     [](bool, auto& view, auto& state) { changeMode(Mode::swipe, view, state); }, "swipe",
     [](auto& state) { return state.mode == Mode::swipe; }},
    {GLFW_KEY_N, 0, "N: nudge", "N: nudge the run, and see how it fits the other one", hasRuns,
     [](bool, auto& view, auto& state) { changeMode(Mode::nudge, view, state); }, "nudge",
     [](auto& state) { return state.mode == Mode::nudge; }},
    {GLFW_KEY_X, GLFW_KEY_Z, "X: stages", "X, Z: next, previous stage of the extraction", hasMap,
     stepStage},
    {GLFW_KEY_D, 0, "", "D: where the runs disagree", hasRuns,
     [](bool, auto&, auto& state) { showOrHide(kDisagreement, state); }},
    {GLFW_KEY_M, 0, "M: measure", "M: measure", always,
     [](bool, auto& view, auto& state) { changeMode(Mode::measure, view, state); }, "measure",
     [](auto& state) { return state.mode == Mode::measure; }},
    {0, 0, "click: read", "click: read what is there", always},
    {0, 0, "wheel: zoom", "wheel, right button: zoom, move", always},
    {0, 0, "Home: all", "Home: all", always},
    {GLFW_KEY_H, GLFW_KEY_F1, "H: keys", "H: all keys", always,
     [](bool, auto&, auto& state) { state.showsKeys = !state.showsKeys; }},
    {0, 0, "Esc: end", "Esc: end what was begun, then the program", always},
};

constexpr const char* kKeysOfMode[] = {  // by Mode
    "", "click: a corner more | Backspace: one less | M or Esc: end",
    ("arrows: 5 cm | Q, E: turn | shift: fine | Enter: fit | R: put back | O: other run | "
     "N or Esc: end"),
    "drag the line, or , and . | tab, O: the runs | W or Esc: end"};

}  // namespace

std::vector<Action> actions() { return {std::begin(kActions), std::end(kActions)}; }

std::pair<const Action*, bool> actionOf(int key, bool isShifted) {
  for (const int pressed : {isShifted ? kShifted | key : key, key})
    for (const Action& action : kActions)
      if (action.run && (pressed == action.key || pressed == action.back))
        return {&action, pressed == action.key};
  return {nullptr, false};
}

std::optional<NudgeStep> nudgeStepOf(int key, bool isShifted) {
  static const std::map<int, NudgeStep> steps = {
      {GLFW_KEY_RIGHT, {{kShift, 0}, 0}}, {GLFW_KEY_LEFT, {{-kShift, 0}, 0}},
      {GLFW_KEY_UP, {{0, kShift}, 0}},    {GLFW_KEY_DOWN, {{0, -kShift}, 0}},
      {GLFW_KEY_Q, {{}, kTurn}},          {GLFW_KEY_E, {{}, -kTurn}}};
  const auto found = steps.find(key);
  if (found == steps.end()) return std::nullopt;
  const double scale = isShifted ? kFine : 1;
  return NudgeStep{scale * found->second.shift, scale * found->second.turn};
}

std::vector<std::string> helpLines(const View& view, const ViewState& state) {
  if (!state.showsKeys && state.mode != Mode::look) return {kKeysOfMode[std::size_t(state.mode)]};
  std::vector<std::string> lines;
  std::string line = !hasFaults(view) ? "" : view.map ? "B: fault" : "B: break";
  for (const Action& action : kActions) {
    if (!action.isOf(view)) continue;
    if (*action.help) lines.emplace_back(action.help);
    if (*action.brief) line += std::string(line.empty() ? "" : " | ") + action.brief;
  }
  return state.showsKeys ? lines : std::vector{line};
}

}  // namespace roomgraph
