#include "ViewWindow.h"

#include <mrpt/gui/CDisplayWindowGUI.h>
#include <mrpt/math/TLine3D.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>

#include "read_place.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"

namespace roomgraph {
namespace {

constexpr const char* kHelp =
    "arrows: key frame | space: play | G: grow | tab: run | B: break | F: flicker | Home: all | "
    "click: read | wheel: zoom | Esc: end";
constexpr int kMostButtons = 8;  // of breaks
constexpr int kClickReach = 3;   // how far the mouse may move in a click [px]

const std::map<int, Wish>& wishes() {
  static const std::map<int, Wish> keys = {
      {GLFW_KEY_RIGHT, Wish::nextFrame}, {GLFW_KEY_LEFT, Wish::previousFrame},
      {GLFW_KEY_UP, Wish::tenOn},        {GLFW_KEY_DOWN, Wish::tenBack},
      {GLFW_KEY_PAGE_UP, Wish::tenOn},   {GLFW_KEY_PAGE_DOWN, Wish::tenBack},
      {GLFW_KEY_SPACE, Wish::play},      {GLFW_KEY_TAB, Wish::nextRun},
      {GLFW_KEY_B, Wish::nextBreak},     {GLFW_KEY_V, Wish::previousBreak},
      {GLFW_KEY_F, Wish::flicker},       {GLFW_KEY_G, Wish::grow}};
  return keys;
}

/** Tells at most so often that a time has passed. */
class Beat {
 public:
  explicit Beat(double seconds) : length_(seconds) {}
  bool isDue() {
    const auto now = std::chrono::steady_clock::now();
    if (std::chrono::duration<double>(now - last_).count() < length_) return false;
    last_ = now;
    return true;
  }

 private:
  double length_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

class Window : public mrpt::gui::CDisplayWindowGUI {
 public:
  Window(View& view, const ViewState& state, int width, int height)
      : CDisplayWindowGUI("roomgraph-view", unsigned(width), unsigned(height), parameters()),
        view_(view),
        drawn_(view),
        state_(state) {
    background_scene = drawn_.scene();
    addPanel();
    performLayout();
    if (state_.tear)
      lookAtTear();
    else
      lookAt(drawn_.box());
    refresh();
  }

 protected:
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override {
    if (action == GLFW_RELEASE)
      return CDisplayWindowGUI::keyboardEvent(key, scancode, action, modifiers);
    const auto wish = wishes().find(key);
    if (wish != wishes().end()) {
      fulfil(wish->second, view_, state_);
      if (state_.tear && (key == GLFW_KEY_B || key == GLFW_KEY_V)) lookAtTear();
    } else if (key == GLFW_KEY_HOME) {
      lookAt(drawn_.box());
    } else if (key == GLFW_KEY_ESCAPE) {
      nanogui::leave();
    } else {
      return CDisplayWindowGUI::keyboardEvent(key, scancode, action, modifiers);
    }
    refresh();
    return true;
  }

  bool mouseButtonEvent(const nanogui::Vector2i& at, int button, bool isDown,
                        int modifiers) override {
    const bool isOnMap = findWidget(at) == this;
    if (button == GLFW_MOUSE_BUTTON_LEFT && isDown) pressed_ = at;
    const bool isClick = !isDown && (at - pressed_).cwiseAbs().maxCoeff() <= kClickReach;
    if (button == GLFW_MOUSE_BUTTON_LEFT && isOnMap && isClick) read(at);
    return CDisplayWindowGUI::mouseButtonEvent(at, button, isDown, modifiers);
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

  void addPanel() {
    nanogui::Window* panel = new nanogui::Window(this, "roomgraph");
    panel->setLayout(
        new nanogui::BoxLayout(nanogui::Orientation::Vertical, nanogui::Alignment::Fill, 8, 3));
    panel->setPosition({10, 110});
    for (const std::string& layer : drawn_.layers()) addLayer(*panel, layer);
    if (view_.comparison.runs.size() > 1 || !view_.path(0).empty()) addFrames(*panel);
    addBreaks(*panel);
    if (view_.map) addOptions(*panel);
  }

  void addLayer(nanogui::Widget& panel, const std::string& layer) {
    auto* box = new nanogui::CheckBox(&panel, printable(layer), [this, layer](bool isOn) {
      if (isOn)
        state_.hidden.erase(layer);
      else
        state_.hidden.insert(layer);
      refresh();
    });
    box->setChecked(true);
  }

  void addFrames(nanogui::Widget& panel) {
    new nanogui::Label(&panel, "key frame");
    frames_ = new nanogui::Slider(&panel);
    frames_->setFixedWidth(190);
    frames_->setCallback([this](float share) {
      const std::size_t count = view_.path(state_.run).size();
      if (count > 0) state_.frame = std::size_t(std::lround(share * float(count - 1)));
      refresh();
    });
  }

  void addBreaks(nanogui::Widget& panel) {
    const auto& breaks = view_.comparison.breaks;
    if (!breaks.empty()) new nanogui::Label(&panel, "breaks");
    for (std::size_t i = 0; i < breaks.size() && i < kMostButtons; ++i) {
      std::string text = printable(breaks[i].run);
      if (breaks[i].keyFrame) text += ", key frame " + std::to_string(*breaks[i].keyFrame);
      auto* button = new nanogui::Button(&panel, text);
      button->setCallback([this, i] {
        lookAtBreak(i, view_, state_);
        lookAtTear();
        refresh();
      });
    }
  }

  /** A slider from 0 to `most` for an option in metres; the map is extracted anew when it is let
   *  go. */
  void addOption(nanogui::Widget& panel, const std::string& name, double& option, double most) {
    auto* label = new nanogui::Label(&panel, "");
    const auto say = [label, name, &option] {
      char text[80];
      std::snprintf(text, sizeof text, "%s: %.2f m", name.c_str(), option);
      label->setCaption(text);
    };
    say();
    auto* slider = new nanogui::Slider(&panel);
    slider->setFixedWidth(190);
    slider->setValue(float(option / most));
    slider->setCallback([say, &option, most](float share) {
      option = double(share) * most;
      say();
    });
    slider->setFinalCallback([this](float) {
      extractAgain(view_);
      drawn_.drawGraphAgain();
      refresh();
    });
  }

  void addOptions(nanogui::Widget& panel) {
    addOption(panel, "one width (0: doors)", view_.options.findRooms.minWidth, 4);
    addOption(panel, "open room", view_.options.splitAtDoors.openRoomWidth, 4);
    addOption(panel, "clutter", view_.options.clearClutter.maxSize, 3);
  }

  void lookAt(const Box& box) {
    const double away = lookDown(*drawn_.scene(), box, double(width()) / std::max(1, height()));
    const Point middle = midpoint(box.low, box.high);
    camera().setCameraProjective(false);
    camera().setAzimuthDegrees(-90), camera().setElevationDegrees(90);
    camera().setCameraPointing(float(middle.x), float(middle.y), 0);
    camera().setZoomDistance(float(away));
  }

  void lookAtTear() { lookAt(drawn_.boxAt(view_.comparison.breaks[*state_.tear])); }

  /** What lies under the mouse. */
  void read(const nanogui::Vector2i& at) {
    mrpt::math::TLine3D ray;
    drawn_.scene()->getViewport()->get3DRayForPixelCoord(at.x() * pixelRatio(),
                                                         at.y() * pixelRatio(), ray);
    if (std::abs(ray.director.z) < 1e-9) return;
    const double along = -ray.pBase.z / ray.director.z;
    read_ = readPlace(view_, state_,
                      {ray.pBase.x + along * ray.director.x, ray.pBase.y + along * ray.director.y});
    refresh();
  }

  void refresh() {
    std::vector<std::string> below = read_;
    below.push_back(kHelp);
    drawn_.update(state_, below);
    const std::size_t count = view_.path(state_.run).size();
    if (frames_ && count > 1) frames_->setValue(float(state_.frame) / float(count - 1));
  }

  View& view_;
  ViewScene drawn_;
  ViewState state_;
  std::vector<std::string> read_;
  nanogui::Vector2i pressed_{0, 0};
  nanogui::Slider* frames_ = nullptr;
  Beat playBeat_{0.1}, flickBeat_{0.5};
};

}  // namespace

void showWindow(View& view, const ViewState& state, int width, int height) {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))
    throw DataError("there is no display for a window: use --screenshot");
  nanogui::init();
  {
    Window window(view, state, width, height);
    window.drawAll();
    window.setVisible(true);
    nanogui::mainloop(20);
  }
  nanogui::shutdown();
}

}  // namespace roomgraph
