#include "view_keys.h"

#include <GLFW/glfw3.h>

#include <cmath>
#include <map>

namespace roomgraph {
namespace {

constexpr double kShift = 0.05;             // [m]
constexpr double kTurn = 0.5 * M_PI / 180;  // [rad]
constexpr double kFine = 0.2;               // of a step

/** A line of help, and where it is true. */
struct KeyHelp {
  const char *keys, *what;
  bool (*isOf)(const View& view);
};

bool always(const View&) { return true; }
bool hasMap(const View& view) { return view.stages.has_value(); }
bool hasPath(const View& view) { return !view.path(0).empty(); }
bool hasRuns(const View& view) { return view.comparison.runs.size() > 1; }
bool hasFaults(const View& view) { return !view.faults.empty(); }

constexpr KeyHelp kKeys[] = {
    {"B, V", "next, previous break or other fault", hasFaults},
    {"right, left", "key frame on, back; up, down: ten; shift: to the end", hasPath},
    {"space", "play", hasPath},
    {"G", "grow: only what was seen up to the key frame", hasPath},
    {"tab", "next run", hasRuns},
    {"O", "other run, to hold against it; at a break: what it shows there", hasRuns},
    {"F", "flicker between the two", hasRuns},
    {"W", "swipe: one run on each side of a line", hasRuns},
    {"N", "nudge the run, and see how it fits the other one", hasRuns},
    {"X, Z", "next, previous stage of the extraction", hasMap},
    {"D", "where the runs disagree", hasRuns},
    {"M", "measure", always},
    {"click", "read what is there", always},
    {"wheel, right button", "zoom, move", always},
    {"Home", "all", always},
    {"H", "all keys", always},
    {"Esc", "end what was begun, then the program", always},
};

}  // namespace

std::optional<Wish> wishOf(int key, bool isShifted) {
  static const std::map<int, Wish> wishes = {
      {GLFW_KEY_RIGHT, Wish::nextFrame}, {GLFW_KEY_LEFT, Wish::previousFrame},
      {GLFW_KEY_UP, Wish::tenOn},        {GLFW_KEY_DOWN, Wish::tenBack},
      {GLFW_KEY_PAGE_UP, Wish::tenOn},   {GLFW_KEY_PAGE_DOWN, Wish::tenBack},
      {GLFW_KEY_SPACE, Wish::play},      {GLFW_KEY_TAB, Wish::nextRun},
      {GLFW_KEY_O, Wish::nextOther},     {GLFW_KEY_B, Wish::nextFault},
      {GLFW_KEY_V, Wish::previousFault}, {GLFW_KEY_F, Wish::flicker},
      {GLFW_KEY_G, Wish::grow},          {GLFW_KEY_X, Wish::nextStage},
      {GLFW_KEY_Z, Wish::previousStage}, {GLFW_KEY_M, Wish::measure},
      {GLFW_KEY_N, Wish::nudge},         {GLFW_KEY_W, Wish::swipe},
      {GLFW_KEY_D, Wish::disagreement},  {GLFW_KEY_H, Wish::keys},
      {GLFW_KEY_F1, Wish::keys}};
  if (isShifted && key == GLFW_KEY_RIGHT) return Wish::lastFrame;
  if (isShifted && key == GLFW_KEY_LEFT) return Wish::firstFrame;
  const auto found = wishes.find(key);
  return found == wishes.end() ? std::nullopt : std::optional(found->second);
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
  if (state.showsKeys) {
    std::vector<std::string> lines;
    for (const KeyHelp& key : kKeys)
      if (key.isOf(view)) lines.push_back(std::string(key.keys) + ": " + key.what);
    return lines;
  }
  switch (state.mode) {
    case Mode::measure:
      return {"click: a corner more | Backspace: one less | M or Esc: end"};
    case Mode::nudge:
      return {
          "arrows: 5 cm | Q, E: turn | shift: fine | Enter: fit | R: put back | "
          "O: other run | N or Esc: end"};
    case Mode::swipe:
      return {"drag the line, or , and . | tab, O: the runs | W or Esc: end"};
    case Mode::look:
      break;
  }
  std::string line;
  const auto add = [&](const char* words, bool isOf) {
    if (isOf) line += std::string(line.empty() ? "" : " | ") + words;
  };
  add(view.map ? "B: fault" : "B: break", hasFaults(view));
  add("arrows: key frame | space: play | G: grow", hasPath(view));
  add("tab: run | O: other | F: flicker | W: swipe | N: nudge", hasRuns(view));
  add("X: stages", hasMap(view));
  add("M: measure | click: read | wheel: zoom | Home: all | H: keys | Esc: end", true);
  return {line};
}

}  // namespace roomgraph
