#pragma once
#include "ViewScene.h"

namespace roomgraph {

/** Opens a window of this size, with this state, [px] and returns when the user closes it.
 *  @throws DataError where there is no display. */
void showWindow(View& view, const ViewState& state, int width, int height);

}  // namespace roomgraph
