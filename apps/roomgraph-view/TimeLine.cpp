#include "TimeLine.h"

#include <nanogui/opengl.h>

#include <algorithm>

#include "draw_marks.h"

namespace roomgraph {
namespace {

constexpr float kFoot = 4, kLeast = 3;  // below the bars, and of the lowest one [px]
const NVGcolor kPaper = nvgRGB(250, 250, 252), kInk = nvgRGB(20, 20, 20),
               kFault = nvgRGB(150, 20, 80);

void fillRect(NVGcontext* context, float x, float y, float width, float height,
              const NVGcolor& colour) {
  nvgBeginPath(context);
  nvgRect(context, x, y, width, height);
  nvgFillColor(context, colour);
  nvgFill(context);
}

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
    fillRect(context, xOf(k) - width / 2, foot - bar, width, bar,
             nvgRGB(colour.R, colour.G, colour.B));
  }
}

/** A flag on a pole. */
void TimeLine::drawFaults(NVGcontext* context) const {
  const float top = float(mPos.y()), foot = float(mPos.y() + mSize.y());
  for (const Fault& fault : view_.faults) {
    if (fault.run != view_.comparison.runs[state_.run].name || !fault.keyFrame) continue;
    const float x = xOf(placeInPath(view_, state_.run, *fault.keyFrame));
    fillRect(context, x - 3, top, 6, foot - top, kPaper);  // to be seen on red bars
    nvgBeginPath(context);
    nvgRect(context, x - 1, top, 2, foot - top);
    nvgMoveTo(context, x, top);
    nvgLineTo(context, x + 12, top + 5);
    nvgLineTo(context, x, top + 10);
    nvgFillColor(context, kFault);
    nvgFill(context);
  }
}

void TimeLine::draw(NVGcontext* context) {
  const auto top = float(mPos.y()), high = float(mSize.y());
  fillRect(context, float(mPos.x()), top, float(mSize.x()), high, kPaper);
  drawBars(context);
  drawFaults(context);
  if (view_.path(state_.run).empty()) return;
  fillRect(context, xOf(state_.frame) - 1.5F, top, 3, high, kInk);
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
