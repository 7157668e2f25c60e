#include "ViewState.h"

#include <algorithm>

namespace roomgraph {
namespace {

constexpr std::size_t kStride = 10;  // of the larger steps [key frames]

void step(bool isForward, std::size_t by, const View& view, ViewState& state) {
  const std::size_t count = view.path(state.run).size();
  if (count == 0) return;
  state.frame =
      isForward ? std::min(state.frame + by, count - 1) : state.frame - std::min(by, state.frame);
}

void stepBreak(bool isForward, const View& view, ViewState& state) {
  const std::size_t count = view.comparison.breaks.size();
  if (count == 0) return;
  const std::size_t before = state.tear ? *state.tear + (isForward ? 1 : count - 1) : 0;
  lookAtBreak(before % count, view, state);
}

void nextRun(const View& view, ViewState& state) {
  state.run = (state.run + 1) % view.comparison.runs.size();
  state.tear.reset();
  const std::size_t count = view.path(state.run).size();
  state.frame = count > 0 ? std::min(state.frame, count - 1) : 0;
}

}  // namespace

void fulfil(Wish wish, const View& view, ViewState& state) {
  const std::size_t count = view.path(state.run).size();
  switch (wish) {
    case Wish::nextFrame:
    case Wish::previousFrame:
      return step(wish == Wish::nextFrame, 1, view, state);
    case Wish::tenOn:
    case Wish::tenBack:
      return step(wish == Wish::tenOn, kStride, view, state);
    case Wish::firstFrame:
    case Wish::lastFrame:
      return step(wish == Wish::lastFrame, count, view, state);
    case Wish::play:
      if (!state.isPlaying && state.frame + 1 >= count) state.frame = 0;
      state.isPlaying = !state.isPlaying && count > 0;
      return;
    case Wish::nextRun:
      return nextRun(view, state);
    case Wish::nextBreak:
    case Wish::previousBreak:
      return stepBreak(wish == Wish::nextBreak, view, state);
    case Wish::flicker:
      state.isFlickering = !state.isFlickering && view.comparison.runs.size() > 1;
      state.isFlicked = false;
      return;
    case Wish::grow:
      state.growsMap = !state.growsMap;
      return;
  }
}

void lookAtBreak(std::size_t tear, const View& view, ViewState& state) {
  const MapBreak& place = view.comparison.breaks[tear];
  state.tear = tear;
  state.isPlaying = false;
  for (std::size_t i = 0; i < view.comparison.runs.size(); ++i)
    if (view.comparison.runs[i].name == place.run) state.run = i;
  state.frame = place.keyFrame.value_or(0);
}

bool playOn(const View& view, ViewState& state) {
  if (!state.isPlaying) return false;
  step(true, 1, view, state);
  if (state.frame + 1 >= view.path(state.run).size()) state.isPlaying = false;
  return true;
}

bool flickOn(ViewState& state) {
  if (!state.isFlickering) return false;
  state.isFlicked = !state.isFlicked;
  return true;
}

}  // namespace roomgraph
