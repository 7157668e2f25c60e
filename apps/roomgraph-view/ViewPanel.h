#pragma once
#include <mrpt/gui/CDisplayWindowGUI.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "ViewScene.h"
#include "view_keys.h"

namespace roomgraph {

/** The panel at the left: layers, what can be done, faults, options of the one map. */
class ViewPanel {
 public:
  /** What the panel calls. */
  struct Calls {
    std::function<void(const Action&)> act;
    std::function<void(std::size_t)> lookAtFault;
    std::function<void()> refresh;       ///< the state has changed
    std::function<void()> extractAgain;  ///< the options of the view have changed
  };

  ViewPanel(nanogui::Screen& screen, View& view, ViewState& state,
            const std::vector<std::string>& layers, Calls calls);

  /** Shows on its buttons what the state is. */
  void follow();

 private:
  void addLayers(nanogui::Widget& panel, const std::vector<std::string>& layers, int height);
  void addButtons(nanogui::Widget& panel);
  void addFaults(nanogui::Widget& panel, int height);
  void addOptions(nanogui::Widget& panel);
  void addOption(nanogui::Widget& panel, const std::string& name, const char* unit, double most,
                 double& option, double* rival);

  View& view_;
  ViewState& state_;
  Calls calls_;
  std::vector<std::pair<Action, nanogui::Button*>> buttons_;
  std::map<std::string, nanogui::CheckBox*> boxes_;  // of the layers
  std::vector<std::function<void()>> captions_;      // of the options
};

}  // namespace roomgraph
