#include "ViewPanel.h"

#include <nanogui/opengl.h>

#include <algorithm>
#include <memory>

#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/mrpt_plugin/draw_comparison.h"

namespace roomgraph {
namespace {

constexpr int kFromTop = 110, kWidth = 190;  // [px]
constexpr int kRow = 30;                     // of a layer or a fault, at most [px]
constexpr int kElsewhere = 220;              // below the panel, and of it without lists [px]
constexpr int kLeastRows = 3;                // of a list
constexpr int kMostRows = 14;                // of the layers of one map
constexpr double kLayersShare = 0.55;        // of what both lists have, where there are faults
constexpr std::size_t kLongest = 30;         // caption [bytes]
constexpr double kQuick = 0.3;  // an extraction that is done while a slider moves takes less [s]

/** A name as a caption, that makes the panel no wider than it need be. */
std::string captionOf(const std::string& name) {
  std::string text = printable(name);
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

/** The layer of a run, with the colour of its walls behind its name. */
class RunBox : public nanogui::CheckBox {
 public:
  RunBox(nanogui::Widget* parent, const std::string& caption, Colour colour)
      : CheckBox(parent, caption), colour_(colour) {}
  nanogui::Vector2i preferredSize(NVGcontext* context) const override {
    return CheckBox::preferredSize(context) + nanogui::Vector2i(2 * kSide, 0);
  }
  void draw(NVGcontext* context) override {
    CheckBox::draw(context);
    const auto side = float(kSide);
    nvgBeginPath(context);
    nvgRect(context, float(mPos.x() + mSize.x()) - side,
            float(mPos.y()) + (float(mSize.y()) - side) / 2, side, side);
    nvgFillColor(context, nvgRGB(colour_.red, colour_.green, colour_.blue));
    nvgFill(context);
  }

 private:
  static constexpr int kSide = 12;  // [px]
  Colour colour_;
};

/** Where the `count` rows of a list go: the panel, or a part of it that scrolls where they are
 *  higher than `height`. */
nanogui::Widget* hostOf(nanogui::Widget& panel, std::size_t count, int height) {
  const int most = std::max(kLeastRows * kRow, height);
  if (int(count) * kRow <= most) return &panel;
  auto* scroll = new nanogui::VScrollPanel(&panel);
  scroll->setFixedSize({kWidth + 20, most});
  auto* host = new nanogui::Widget(scroll);
  host->setLayout(
      new nanogui::BoxLayout(nanogui::Orientation::Vertical, nanogui::Alignment::Fill, 0, 3));
  return host;
}

}  // namespace

ViewPanel::ViewPanel(nanogui::Screen& screen, View& view, ViewState& state,
                     const std::vector<std::string>& layers, Calls calls)
    : view_(view), state_(state), calls_(std::move(calls)) {
  auto* panel = new nanogui::Window(&screen, "roomgraph");
  panel->setLayout(
      new nanogui::BoxLayout(nanogui::Orientation::Vertical, nanogui::Alignment::Fill, 8, 3));
  panel->setPosition({10, kFromTop});
  const int lists = screen.height() - kFromTop - kElsewhere;
  const bool hasFaults = !view.faults.empty();
  const int ofLayers = hasFaults ? int(kLayersShare * lists) : lists;
  addLayers(*panel, layers, view_.map ? kMostRows * kRow : ofLayers);
  addButtons(*panel);
  const int used = std::min(ofLayers, int(layers.size()) * kRow);
  if (hasFaults) addFaults(*panel, lists - used);
  if (view_.map) addOptions(*panel);
}

void ViewPanel::addLayers(nanogui::Widget& panel, const std::vector<std::string>& layers,
                          int height) {
  nanogui::Widget* host = hostOf(panel, layers.size(), height);
  const auto& runs = view_.comparison.runs;
  for (const std::string& layer : layers) {
    const std::string caption = captionOf(nameOfLayer(layer));
    const ComparedRun* run =
        findIf(runs, [&](const ComparedRun& one) { return runLayer(one.name) == layer; });
    auto* box = run ? new RunBox(host, caption, runColour(std::size_t(run - runs.data())))
                    : new nanogui::CheckBox(host, caption);
    box->setCallback([this, layer](bool) {
      showOrHide(layer, state_);
      calls_.refresh();
    });
    boxes_[layer] = box;
  }
}

void ViewPanel::addButtons(nanogui::Widget& panel) {
  auto* tools = new nanogui::Widget(&panel);
  tools->setLayout(
      new nanogui::GridLayout(nanogui::Orientation::Horizontal, 2, nanogui::Alignment::Fill, 0, 3));
  for (const Action& action : actions()) {
    if (!action.button || !action.isOf(view_)) continue;
    auto* button = new nanogui::Button(tools, action.button);
    button->setFlags(nanogui::Button::ToggleButton);
    button->setFontSize(15);
    button->setChangeCallback([this, action](bool) { calls_.act(action); });
    buttons_.emplace_back(action, button);
  }
}

void ViewPanel::addFaults(nanogui::Widget& panel, int height) {
  new nanogui::Label(&panel, view_.map ? "faults" : "breaks, the largest first");
  nanogui::Widget* host = hostOf(panel, view_.faults.size(), height);
  for (std::size_t i = 0; i < view_.faults.size(); ++i) {
    const Fault& fault = view_.faults[i];
    std::string text = view_.map ? nameOf(fault.kind) : captionOf(fault.run);
    if (fault.keyFrame) text += ", " + std::to_string(*fault.keyFrame);
    auto* button = new nanogui::Button(host, text);
    button->setFontSize(15);
    button->setCallback([this, i] { calls_.lookAtFault(i); });
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
    label->setCaption(formatted("%s: %.2f %s", name.c_str(), option, unit));
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
  for (const auto& [action, button] : buttons_) button->setPushed(action.isOn(state_));
  for (const auto& [layer, box] : boxes_) box->setChecked(state_.hidden.count(layer) == 0);
}

}  // namespace roomgraph
