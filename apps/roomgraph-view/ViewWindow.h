#pragma once
#include <functional>

#include "ViewScene.h"

namespace roomgraph {

/** What a window is opened on. */
struct WindowTask {
  std::function<View()> load;
  std::string words;  ///< that say what is being done meanwhile
  std::function<ViewState(const View&)> firstState;
  int width = 0, height = 0;  ///< [px]
};

/** Opens a window at once, which waits for what it is to show; returns when the user closes it.
 *  @throws DataError where there is no display, and what the functions throw. */
void showWindow(const WindowTask& task);

}  // namespace roomgraph
