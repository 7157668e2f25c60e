#include "TimeLine.h"

#include <nanogui/opengl.h>

#include <algorithm>

#include "draw_marks.h"

namespace roomgraph {
namespace {

constexpr float kFoot = 4, kLeast = 3;  // below the bars, and of the lowest one [px]
const NVGcolor kPaper = nvgRGB(250, 250, 252), kInk = nvgRGB(20, 20, 20),
               kBreak = nvgRGB(150, 20, 80);

}  // namespace

float TimeLine::xOf(std::size_t frame) const {
  const std::size_t count = view_.path(state_.run).size();
  return float(mPos.x()) +
         float(mSize.x()) * (float(frame) + 0.5F) / float(std::max<std::size_t>(1, count));
}

void TimeLine::chooseAt(int x) {
  const std::size_t count = view_.path(state_.run).size();
  if (count == 0) return;
  const double share = double(x - mPos.x()) / std::max(1, mSize.x());
  choose_(std::size_t(std::clamp(share * double(count), 0.0, double(count - 1))));
}

void TimeLine::drawBars(NVGcontext* context) const {
  const auto& path = view_.path(state_.run);
  const float high = float(mSize.y()) - 2 * kFoot, foot = float(mPos.y() + mSize.y()) - kFoot;
  const float width =
      std::max(1.F, float(mSize.x()) / float(std::max<std::size_t>(1, path.size())));
  double worst = kWorstError;
  for (const PathPose& at : path) worst = std::max(worst, at.error.value_or(0));
  for (std::size_t k = 0; k < path.size(); ++k) {
    const double share = path[k].error.value_or(0) / worst;
    const float bar = std::max(kLeast, high * float(share));
    const auto colour = colourOfError(path[k].error);
    nvgBeginPath(context);
    nvgRect(context, xOf(k) - width / 2, foot - bar, width, bar);
    nvgFillColor(context, nvgRGB(colour.R, colour.G, colour.B));
    nvgFill(context);
  }
}

/** A flag on a pole. */
void TimeLine::drawBreaks(NVGcontext* context) const {
  const float top = float(mPos.y()), foot = float(mPos.y() + mSize.y());
  for (const MapBreak& tear : view_.comparison.breaks) {
    if (tear.run != view_.comparison.runs[state_.run].name || !tear.keyFrame) continue;
    const float x = xOf(placeInPath(view_, state_.run, *tear.keyFrame));
    nvgBeginPath(context);  // light round it, to be seen on red bars
    nvgRect(context, x - 3, top, 6, foot - top);
    nvgFillColor(context, kPaper);
    nvgFill(context);
    nvgBeginPath(context);
    nvgRect(context, x - 1, top, 2, foot - top);
    nvgMoveTo(context, x, top);
    nvgLineTo(context, x + 12, top + 5);
    nvgLineTo(context, x, top + 10);
    nvgFillColor(context, kBreak);
    nvgFill(context);
  }
}

void TimeLine::draw(NVGcontext* context) {
  nvgBeginPath(context);
  nvgRect(context, float(mPos.x()), float(mPos.y()), float(mSize.x()), float(mSize.y()));
  nvgFillColor(context, kPaper);
  nvgFill(context);
  drawBars(context);
  drawBreaks(context);
  if (view_.path(state_.run).empty()) return;
  nvgBeginPath(context);
  nvgRect(context, xOf(state_.frame) - 1.5F, float(mPos.y()), 3, float(mSize.y()));
  nvgFillColor(context, kInk);
  nvgFill(context);
}

bool TimeLine::mouseButtonEvent(const nanogui::Vector2i& at, int button, bool isDown, int) {
  if (button == GLFW_MOUSE_BUTTON_LEFT && isDown) chooseAt(at.x());
  return true;
}

bool TimeLine::mouseDragEvent(const nanogui::Vector2i& at, const nanogui::Vector2i&, int, int) {
  chooseAt(at.x());
  return true;
}

}  // namespace roomgraph
