#include "pace.h"

#include <mrpt/gui/CDisplayWindowGUI.h>
#include <nanogui/opengl.h>

#include <chrono>
#include <cstdlib>
#include <future>

#include "roomgraph/mrpt_plugin/colours.h"

namespace roomgraph {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds kMoment{150}, kBetweenPictures{60};
constexpr float kLetters = 20;  // [px]

/** An empty sheet with a line in its middle. */
class WaitingWindow : public nanogui::Screen {
 public:
  WaitingWindow(const std::string& words, int width, int height)
      : Screen({width, height}, "roomgraph-view", false), words_(words) {
    setBackground(nanogui::Color(kBackgroundColour.red, kBackgroundColour.green,
                                 kBackgroundColour.blue, 255));
  }

  void draw(NVGcontext* context) override {
    Screen::draw(context);
    nvgFontFace(context, "sans");
    nvgFontSize(context, kLetters);
    nvgTextAlign(context, NVG_ALIGN_CENTER | NVG_ALIGN_MIDDLE);
    nvgFillColor(context, nvgRGB(30, 34, 40));
    nvgText(context, float(width()) / 2, float(height()) / 2, words_.c_str(), nullptr);
  }

 private:
  std::string words_;
};

/** What it has in OpenGL lies in its own context, whatever was drawn last. */
void close(WaitingWindow* window) {
  glfwMakeContextCurrent(window->glfwWindow());
  delete window;
}

}  // namespace

std::shared_ptr<void> waitBeside(const std::function<void()>& work, const std::string& words,
                                 int width, int height) {
  std::shared_ptr<WaitingWindow> window;
  std::future<void> done = std::async(std::launch::async, work);
  if (done.wait_for(kMoment) != std::future_status::ready) {
    window = {new WaitingWindow(words, width, height), close};
    window->setVisible(true);
    while (done.wait_for(kBetweenPictures) != std::future_status::ready) {
      glfwPollEvents();
      if (glfwWindowShouldClose(window->glfwWindow())) std::_Exit(0);
      window->drawAll();
    }
  }
  done.get();
  return window;
}

}  // namespace roomgraph
