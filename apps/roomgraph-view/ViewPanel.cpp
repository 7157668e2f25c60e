#include "ViewPanel.h"

#include <cstdio>
#include <memory>

#include "roomgraph/base/printable.h"

namespace roomgraph {
namespace {

constexpr int kMostButtons = 8;                   // of breaks
constexpr std::size_t kMostLayers = 14;           // more can be scrolled
constexpr int kScrollHeight = 320, kWidth = 190;  // [px]
constexpr double kQuick = 0.3;  // an extraction that is done while a slider moves takes less [s]

/** Whether what a toggle stands for is on. */
bool isOn(Wish wish, const ViewState& state) {
  switch (wish) {
    case Wish::play:
      return state.isPlaying;
    case Wish::grow:
      return state.growsMap;
    case Wish::flicker:
      return state.isFlickering;
    case Wish::swipe:
      return state.mode == Mode::swipe;
    case Wish::nudge:
      return state.mode == Mode::nudge;
    case Wish::measure:
      return state.mode == Mode::measure;
    default:
      return false;
  }
}

}  // namespace

ViewPanel::ViewPanel(nanogui::Screen& screen, View& view, ViewState& state,
                     const std::vector<std::string>& layers, Calls calls)
    : view_(view), state_(state), calls_(std::move(calls)) {
  auto* panel = new nanogui::Window(&screen, "roomgraph");
  panel->setLayout(
      new nanogui::BoxLayout(nanogui::Orientation::Vertical, nanogui::Alignment::Fill, 8, 3));
  panel->setPosition({10, 110});
  addLayers(*panel, layers);
  addWishes(*panel);
  addBreaks(*panel);
  if (view_.map) addOptions(*panel);
}

void ViewPanel::addLayers(nanogui::Widget& panel, const std::vector<std::string>& layers) {
  nanogui::Widget* host = &panel;
  if (layers.size() > kMostLayers) {
    auto* scroll = new nanogui::VScrollPanel(&panel);
    scroll->setFixedSize({kWidth + 20, kScrollHeight});
    host = new nanogui::Widget(scroll);
    host->setLayout(
        new nanogui::BoxLayout(nanogui::Orientation::Vertical, nanogui::Alignment::Fill, 0, 3));
  }
  for (const std::string& layer : layers) {
    auto* box = new nanogui::CheckBox(host, printable(layer), [this, layer](bool isShown) {
      if (isShown)
        state_.hidden.erase(layer);
      else
        state_.hidden.insert(layer);
      calls_.refresh();
    });
    boxes_[layer] = box;
  }
}

void ViewPanel::addWishes(nanogui::Widget& panel) {
  auto* tools = new nanogui::Widget(&panel);
  tools->setLayout(
      new nanogui::GridLayout(nanogui::Orientation::Horizontal, 2, nanogui::Alignment::Fill, 0, 3));
  const auto add = [&](Wish wish, const char* name) {
    auto* button = new nanogui::Button(tools, name);
    button->setFlags(nanogui::Button::ToggleButton);
    button->setFontSize(15);
    button->setChangeCallback([this, wish](bool) { calls_.wish(wish); });
    buttons_[wish] = button;
  };
  if (!view_.path(0).empty()) add(Wish::play, "play"), add(Wish::grow, "grow");
  if (view_.comparison.runs.size() > 1) {
    add(Wish::flicker, "flicker"), add(Wish::swipe, "swipe");
    add(Wish::nudge, "nudge");
  }
  add(Wish::measure, "measure");
}

void ViewPanel::addBreaks(nanogui::Widget& panel) {
  const auto& breaks = view_.comparison.breaks;
  if (!breaks.empty()) new nanogui::Label(&panel, "breaks");
  for (std::size_t i = 0; i < breaks.size() && i < kMostButtons; ++i) {
    std::string text = printable(breaks[i].run);
    if (breaks[i].keyFrame) text += ", key frame " + std::to_string(*breaks[i].keyFrame);
    auto* button = new nanogui::Button(&panel, text);
    button->setCallback([this, i] { calls_.lookAtBreak(i); });
  }
}

/** A slider from 0 to `most`. The map is extracted anew as it moves, or, where that takes long,
 *  when it is let go. `rival` says the same in another way, and is put to 0. */
void ViewPanel::addOption(nanogui::Widget& panel, const std::string& name, const char* unit,
                          double most, double& option, double* rival) {
  auto* label = new nanogui::Label(&panel, "");
  auto* slider = new nanogui::Slider(&panel);
  slider->setFixedWidth(kWidth);
  captions_.push_back([label, slider, name, unit, most, &option] {
    char text[80];
    std::snprintf(text, sizeof text, "%s: %.2f %s", name.c_str(), option, unit);
    label->setCaption(text);
    slider->setValue(float(option / most));
  });
  const auto done = std::make_shared<double>(option);  // what it was extracted with last
  const auto extract = [this, &option, done] {
    if (*done == option) return;
    *done = option;
    calls_.extractAgain();
  };
  slider->setCallback([this, &option, most, rival, extract](float share) {
    option = double(share) * most;
    if (rival && option > 0) *rival = 0;
    for (const auto& caption : captions_) caption();
    if (view_.seconds < kQuick) extract();
  });
  slider->setFinalCallback([extract](float) { extract(); });
  captions_.back()();
}

void ViewPanel::addOptions(nanogui::Widget& panel) {
  FindRoomsOptions& rooms = view_.options.findRooms;
  addOption(panel, "alpha (0: doors)", "px2", 1000, rooms.alphaPx2, &rooms.minWidth);
  addOption(panel, "room width (0: doors)", "m", 4, rooms.minWidth, &rooms.alphaPx2);
  addOption(panel, "open room", "m", 4, view_.options.splitAtDoors.openRoomWidth, nullptr);
  addOption(panel, "clutter", "m", 3, view_.options.clearClutter.maxSize, nullptr);
}

void ViewPanel::follow() {
  for (const auto& [wish, button] : buttons_) button->setPushed(isOn(wish, state_));
  for (const auto& [layer, box] : boxes_) box->setChecked(state_.hidden.count(layer) == 0);
}

}  // namespace roomgraph
