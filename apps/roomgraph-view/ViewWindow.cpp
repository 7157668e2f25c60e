#include "ViewWindow.h"

#include <mrpt/gui/CDisplayWindowGUI.h>
#include <nanogui/opengl.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "TimeLine.h"
#include "ViewPanel.h"
#include "ViewState.h"
#include "pace.h"
#include "read_place.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"
#include "view_keys.h"

namespace roomgraph {
namespace {

constexpr float kFontSize = 16, kLineHeight = 18, kTextMargin = 4;  // [px]
constexpr int kClickReach = 3;     // how far the mouse may move in a click [px]
constexpr int kLineReach = 8;      // how near to the line of a swipe it is caught [px]
constexpr double kSwipeStep = 50;  // of the keys , and ., in the width of the picture

/** Dark on light, from the left edge. */
void drawText(NVGcontext* context, float top, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  nvgFontFace(context, "sans");
  nvgFontSize(context, kFontSize);
  nvgTextAlign(context, NVG_ALIGN_LEFT | NVG_ALIGN_TOP);
  float width = 0;
  for (const std::string& line : lines)
    width = std::max(width, nvgTextBounds(context, 0, 0, line.c_str(), nullptr, nullptr));
  nvgBeginPath(context);
  nvgRect(context, 0, top, width + 4 * kTextMargin,
          kLineHeight * float(lines.size()) + 2 * kTextMargin);
  nvgFillColor(context, nvgRGBA(255, 255, 255, 225));
  nvgFill(context);
  nvgFillColor(context, nvgRGB(30, 34, 40));
  for (std::size_t i = 0; i < lines.size(); ++i)
    nvgText(context, 2 * kTextMargin, top + kTextMargin + kLineHeight * float(i), lines[i].c_str(),
            nullptr);
}

class Window : public mrpt::gui::CDisplayWindowGUI {
 public:
  Window(View& view, const ViewState& state, int width, int height)
      : CDisplayWindowGUI("roomgraph-view", unsigned(width), unsigned(height), parameters()),
        view_(view),
        drawn_(view),
        state_(state),
        panel_(*this, view, state_, drawn_.layers(), panelCalls()) {
    background_scene = drawn_.scene();
    addTimeLine();
    performLayout();
    if (state_.fault)
      lookAtFaultNow();
    else
      lookAt(drawn_.box());
    refresh();
  }

 protected:
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override {
    const bool isShifted = (modifiers & GLFW_MOD_SHIFT) != 0;
    if (action == GLFW_RELEASE || !(isKeyOfMode(key, isShifted) || isKeyOfAll(key, isShifted)))
      return CDisplayWindowGUI::keyboardEvent(key, scancode, action, modifiers);
    refresh();
    return true;
  }

  bool mouseButtonEvent(const nanogui::Vector2i& at, int button, bool isDown,
                        int modifiers) override {
    const bool isOnMap = findWidget(at) == this, isLeft = button == GLFW_MOUSE_BUTTON_LEFT;
    if (isLeft && isDown) pressed_ = at;
    if (isLeft && !isDown && isSwiping_) {
      isSwiping_ = false;
      return true;
    }
    if (isLeft && isDown && isOnMap && isOnLine(at)) return isSwiping_ = true;
    const bool isClick = !isDown && (at - pressed_).cwiseAbs().maxCoeff() <= kClickReach;
    if (isLeft && isOnMap && isClick) click(at);
    return CDisplayWindowGUI::mouseButtonEvent(at, button, isDown, modifiers);
  }

  bool mouseMotionEvent(const nanogui::Vector2i& at, const nanogui::Vector2i& by, int button,
                        int modifiers) override {
    if (!isSwiping_) return CDisplayWindowGUI::mouseMotionEvent(at, by, button, modifiers);
    if (const auto place = placeAt(at)) state_.swipe = view_.onScreen()(*place).x;
    refresh();
    return true;
  }

  bool resizeEvent(const nanogui::Vector2i& size) override {
    layTimeLine();
    return CDisplayWindowGUI::resizeEvent(size);
  }

  /** What the scene itself writes in pictures stands on paper here, above all else. */
  void draw(NVGcontext* context) override {
    CDisplayWindowGUI::draw(context);
    drawText(context, kTextMargin, readState(view_, state_));
    const std::vector<std::string> below = linesBelow();
    drawText(context,
             float(height() - bottom()) - kLineHeight * float(below.size()) - 2 * kTextMargin,
             below);
  }

  void drawContents() override {
    if (playBeat_.isDue() && playOn(view_, state_)) refresh();
    if (flickBeat_.isDue() && flickOn(state_)) refresh();
    clipFor(double(camera().getZoomDistance()), *drawn_.scene());
    CDisplayWindowGUI::drawContents();
  }

 private:
  static mrpt::gui::CDisplayWindowGUI_Params parameters() {
    mrpt::gui::CDisplayWindowGUI_Params parameters;
    parameters.maximized = false;
    return parameters;
  }

  ViewPanel::Calls panelCalls() {
    return {[this](const Action& action) { act(action, true); },
            [this](std::size_t number) {
              lookAtFault(number, view_, state_);
              lookAtFaultNow();
              refresh();
            },
            [this] { refresh(); },
            [this] {
              extractAgain(view_);
              drawn_.drawGraphAgain();
              refresh();
            }};
  }

  void addTimeLine() {
    if (view_.path(0).empty() && view_.comparison.runs.size() < 2) return;
    timeLine_ = new TimeLine(this, view_, state_, [this](std::size_t frame) {
      state_.frame = frame;
      refresh();
    });
    layTimeLine();
  }

  void layTimeLine() {
    if (!timeLine_) return;
    timeLine_->setPosition({0, height() - TimeLine::kHeight});
    timeLine_->setSize({width(), TimeLine::kHeight});
  }

  /** Keys that mean something else than usual in a mode. */
  bool isKeyOfMode(int key, bool isShifted) {
    if (state_.mode == Mode::nudge) return isKeyOfNudging(key, isShifted);
    if (state_.mode == Mode::measure && key == GLFW_KEY_BACKSPACE) {
      if (!state_.corners.empty()) state_.corners.pop_back();
      return true;
    }
    const int step = key == GLFW_KEY_PERIOD ? 1 : key == GLFW_KEY_COMMA ? -1 : 0;
    if (state_.mode != Mode::swipe || step == 0) return false;
    const Box& box = drawn_.box();
    *state_.swipe += step * (box.high.x - box.low.x) / kSwipeStep;
    return true;
  }

  bool isKeyOfNudging(int key, bool isShifted) {
    if (const auto step = nudgeStepOf(key, isShifted))
      nudgeBy(view_.onScreen().inverse()(step->shift), step->turn, view_, state_);
    else if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER)
      fitNudge(view_, state_);
    else if (key == GLFW_KEY_R)
      state_.nudge = {};
    else
      return false;
    return true;
  }

  bool isKeyOfAll(int key, bool isShifted) {
    if (const auto [action, isForward] = actionOf(key, isShifted); action)
      act(*action, isForward);
    else if (key == GLFW_KEY_HOME)
      lookAt(drawn_.box());
    else if (key == GLFW_KEY_ESCAPE && isBusy(state_))
      leave(state_);
    else if (key == GLFW_KEY_ESCAPE)
      nanogui::leave();
    else
      return false;
    return true;
  }

  void act(const Action& action, bool isForward) {
    action.run(isForward, view_, state_);
    if (state_.mode == Mode::swipe && !state_.swipe)
      state_.swipe =
          view_.onScreen()(Point{camera().getCameraPointingX(), camera().getCameraPointingY()}).x;
    if (state_.fault && action.run == stepFault) lookAtFaultNow();
    refresh();
  }

  void lookAt(const Box& box) {
    const double away =
        lookDown(*drawn_.scene(), box, view_.turn, double(width()) / std::max(1, height()));
    const auto& looks = drawn_.scene()->getViewport()->getCamera();
    camera().setCameraProjective(false);
    camera().setAzimuthDegrees(looks.getAzimuthDegrees()), camera().setElevationDegrees(90);
    camera().setCameraPointing(looks.getPointingAtX(), looks.getPointingAtY(), 0);
    camera().setZoomDistance(float(away));
  }

  void lookAtFaultNow() { lookAt(drawn_.boxAt(view_.faults[*state_.fault])); }

  /** The place on the map that lies under the mouse; none where one looks along it. */
  std::optional<Point> placeAt(const nanogui::Vector2i& at) {
    const auto ray = rayThrough(*drawn_.scene()->getViewport(), float(at.x()) * pixelRatio(),
                                float(at.y()) * pixelRatio());
    if (!ray || std::abs(ray->director.z) < 1e-9) return std::nullopt;
    const double along = -ray->pBase.z / ray->director.z;
    return Point{ray->pBase.x + along * ray->director.x, ray->pBase.y + along * ray->director.y};
  }

  bool isOnLine(const nanogui::Vector2i& at) {
    if (state_.mode != Mode::swipe || !state_.swipe) return false;
    const auto low = placeAt({at.x() - kLineReach, at.y()});
    const auto high = placeAt({at.x() + kLineReach, at.y()});
    if (!low || !high) return false;
    const auto [left, right] = std::minmax({view_.onScreen()(*low).x, view_.onScreen()(*high).x});
    return left <= *state_.swipe && *state_.swipe <= right;
  }

  void click(const nanogui::Vector2i& at) {
    const auto place = placeAt(at);
    if (!place) return;
    if (state_.mode == Mode::measure) {
      state_.corners.push_back(*place);
    } else {
      state_.read = place;
      read_ = readPlace(view_, state_, *place);
    }
    refresh();
  }

  std::vector<std::string> linesBelow() const {
    std::vector<std::string> lines = state_.showsKeys ? std::vector<std::string>() : read_;
    for (const std::string& line : helpLines(view_, state_)) lines.push_back(line);
    return lines;
  }

  int bottom() const { return timeLine_ ? TimeLine::kHeight : 0; }

  void refresh() {
    drawn_.update(state_);
    panel_.follow();
  }

  View& view_;
  ViewScene drawn_;
  ViewState state_;
  ViewPanel panel_;
  std::vector<std::string> read_;
  nanogui::Vector2i pressed_{0, 0};
  TimeLine* timeLine_ = nullptr;
  bool isSwiping_ = false;  // the line is being dragged
  Beat playBeat_{0.1}, flickBeat_{0.5};
};

/** nanogui, as long as it is needed. */
struct Toolkit {
  Toolkit() { nanogui::init(); }
  ~Toolkit() { nanogui::shutdown(); }
  Toolkit(const Toolkit&) = delete;
  Toolkit& operator=(const Toolkit&) = delete;
};

}  // namespace

void showWindow(const WindowTask& task) {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))
    throw DataError("there is no display for a window: use --screenshot");
  const Toolkit toolkit;
  std::optional<View> view;
  std::shared_ptr<void> waiting =
      waitBeside([&] { view = task.load(); }, task.words, task.width, task.height);
  Window window(*view, task.firstState(*view), task.width, task.height);
  window.drawAll();
  window.setVisible(true);
  waiting.reset();
  nanogui::mainloop(20);
}

}  // namespace roomgraph
