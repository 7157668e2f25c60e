#include "ViewState.h"

#include <algorithm>

#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/align/refine_alignment.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/drawing/stage_names.h"

namespace roomgraph {
namespace {

/** The maps of the other run and of the one that is moved. */
struct TwoMaps {
  const WallMap *other, *moved;
  Transform2D otherPose, pose;  ///< other <- moved
};

std::optional<TwoMaps> twoMaps(const View& view, const ViewState& state) {
  const auto other = otherRun(view, state);
  if (!other) return std::nullopt;
  const Run* a = view.runNamed(view.comparison.runs[*other].name);
  const Run* b = view.runNamed(view.comparison.runs[state.run].name);
  if (!a || !b) return std::nullopt;
  const Transform2D& otherPose = view.comparison.runs[*other].pose;
  return TwoMaps{&a->map, &b->map, otherPose,
                 otherPose.inverse() * shownPose(view, state, state.run)};
}

void showRun(std::size_t run, const View& view, ViewState& state) {
  state.run = run;
  state.nudge = {};
  if (state.other == run) state.other.reset();
  const std::size_t count = view.path(run).size();
  state.frame = count > 0 ? std::min(state.frame, count - 1) : 0;
}

}  // namespace

std::optional<NudgeFit> nudgeFit(const View& view, const ViewState& state) {
  const auto maps = twoMaps(view, state);
  if (!maps) return std::nullopt;
  const AlignmentEvidence evidence = verifyAlignment(*maps->other, *maps->moved, maps->pose);
  const double known = std::max(1e-9, evidence.known);
  return NudgeFit{evidence.overlap, std::min(1.0, evidence.loose / known),
                  std::min(1.0, evidence.contradicted / known), alignmentScore(evidence)};
}

void fitNudge(const View& view, ViewState& state) {
  const auto maps = twoMaps(view, state);
  if (state.mode != Mode::nudge || !maps) return;
  const Transform2D pose = refineAlignment(*maps->other, *maps->moved, maps->pose);
  state.nudge = maps->otherPose * pose * view.comparison.runs[state.run].pose.inverse();
}

void stepFrames(bool isForward, std::size_t by, const View& view, ViewState& state) {
  const std::size_t count = view.path(state.run).size();
  if (count == 0) return;
  state.frame =
      isForward ? std::min(state.frame + by, count - 1) : state.frame - std::min(by, state.frame);
}

void stepFault(bool isForward, const View& view, ViewState& state) {
  const std::size_t count = view.faults.size();
  if (count == 0) return;
  const std::size_t before = state.fault ? *state.fault + (isForward ? 1 : count - 1) : 0;
  lookAtFault(before % count, view, state);
}

void stepStage(bool isForward, const View& view, ViewState& state) {
  if (!view.stages) return;
  const std::size_t count = stageNames().size();  // the result counts as one more
  const std::size_t now = state.stage.value_or(count);
  const std::size_t stage = (now + (isForward ? 1 : count)) % (count + 1);
  state.stage = stage < count ? std::optional(stage) : std::nullopt;
}

void nextRun(const View& view, ViewState& state) {
  state.fault.reset();
  showRun((state.run + 1) % view.comparison.runs.size(), view, state);
}

void nextOther(const View& view, ViewState& state) {
  const auto other = otherRun(view, state);
  if (!other) return;
  if (state.fault && !state.other) {  // none is shown there yet
    state.other = other;
    return;
  }
  const std::size_t count = view.comparison.runs.size();
  std::size_t next = (*other + 1) % count;
  if (next == state.run) next = (next + 1) % count;
  state.other = next;
}

void play(const View& view, ViewState& state) {
  const std::size_t count = view.path(state.run).size();
  if (!state.isPlaying && state.frame + 1 >= count) state.frame = 0;
  state.isPlaying = !state.isPlaying && count > 0;
}

void changeMode(Mode mode, const View& view, ViewState& state) {
  const bool isLeft = state.mode == mode;
  const bool needsOther = mode == Mode::swipe || mode == Mode::nudge;
  if (!isLeft && needsOther && !otherRun(view, state)) return;
  state.mode = isLeft ? Mode::look : mode;
  state.corners.clear();
  state.nudge = {};
  state.swipe.reset();
  if (state.mode != Mode::look) state.isFlickering = state.isFlicked = false;
}

void leave(ViewState& state) {
  state.mode = Mode::look;
  state.isFlickering = state.isFlicked = state.isPlaying = state.showsKeys = false;
  state.nudge = {};
  state.corners.clear();
  state.swipe.reset();
  state.fault.reset();
  state.other.reset();
  state.stage.reset();
}

void flicker(const View& view, ViewState& state) {
  state.isFlickering = !state.isFlickering && otherRun(view, state);
  state.isFlicked = false;
  if (state.isFlickering) state.mode = Mode::look;
}

void showOrHide(const std::string& layer, ViewState& state) {
  if (state.hidden.erase(layer) == 0) state.hidden.insert(layer);
}

void lookAtFault(std::size_t number, const View& view, ViewState& state) {
  const Fault& fault = view.faults[number];
  state.fault = number;
  state.isPlaying = false;
  for (std::size_t i = 0; i < view.comparison.runs.size(); ++i)
    if (view.comparison.runs[i].name == fault.run) showRun(i, view, state);
  state.frame = placeInPath(view, state.run, fault.keyFrame.value_or(0));
}

std::size_t placeInPath(const View& view, std::size_t run, std::size_t keyFrame) {
  const auto& path = view.path(run);
  const PathPose* found = findIf(path, [&](const PathPose& at) { return at.keyFrame >= keyFrame; });
  return found ? std::size_t(found - path.data()) : 0;
}

std::optional<std::size_t> otherRun(const View& view, const ViewState& state) {
  if (view.comparison.runs.size() < 2) return std::nullopt;
  return state.other.value_or(state.run == 0 ? 1 : 0);
}

void nudgeBy(Point shift, double turn, const View& view, ViewState& state) {
  const Run* run = view.runNamed(view.comparison.runs[state.run].name);
  if (state.mode != Mode::nudge || !run) return;
  const Point pivot = shownPose(view, state, state.run)(run->map.middle());
  state.nudge = carrying(pivot, pivot + shift, turn) * state.nudge;
}

Transform2D shownPose(const View& view, const ViewState& state, std::size_t run) {
  const Transform2D& pose = view.comparison.runs[run].pose;
  return run == state.run ? state.nudge * pose : pose;
}

bool isBusy(const ViewState& state) {
  return state.mode != Mode::look || state.isFlickering || state.isPlaying || state.showsKeys ||
         state.fault || state.stage;
}

bool playOn(const View& view, ViewState& state) {
  if (!state.isPlaying) return false;
  stepFrames(true, 1, view, state);
  if (state.frame + 1 >= view.path(state.run).size()) state.isPlaying = false;
  return true;
}

bool flickOn(ViewState& state) {
  if (!state.isFlickering) return false;
  state.isFlicked = !state.isFlicked;
  return true;
}

}  // namespace roomgraph
