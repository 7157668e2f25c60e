#pragma once
#include <mrpt/gui/CDisplayWindowGUI.h>

#include <functional>

#include "ViewState.h"

namespace roomgraph {

/** The path of the run as a strip: for each key frame a bar as high as its error, of the largest
 *  one, and as red as on the map; a mark for each fault, and a line where the shown one is. A click
 *  or a drag chooses a key frame. */
class TimeLine : public nanogui::Widget {
 public:
  static constexpr int kHeight = 44;  // [px]

  TimeLine(nanogui::Widget* parent, const View& view, const ViewState& state,
           std::function<void(std::size_t)> choose)
      : Widget(parent), view_(view), state_(state), choose_(std::move(choose)) {}

  void draw(NVGcontext* context) override;
  bool mouseButtonEvent(const nanogui::Vector2i& at, int button, bool isDown,
                        int modifiers) override;
  bool mouseDragEvent(const nanogui::Vector2i& at, const nanogui::Vector2i& by, int button,
                      int modifiers) override;

 private:
  void drawBars(NVGcontext* context) const;
  void drawFaults(NVGcontext* context) const;
  float xOf(std::size_t frame) const;
  void chooseAt(int x);

  const View& view_;
  const ViewState& state_;
  std::function<void(std::size_t)> choose_;
};

}  // namespace roomgraph
