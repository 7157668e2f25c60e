#pragma once
#include <string>
#include <vector>

#include "ViewState.h"

namespace roomgraph {

/** What there is to say of a place [m, frame of the site, or of the one map]: a line each for the
 *  place, the room, the nearest vertex and path of the graph, and the nearest key frame. */
std::vector<std::string> readPlace(const View& view, const ViewState& state, Point place);

/** What there is to say of the key frame, and of the break that is looked at. */
std::vector<std::string> readState(const View& view, const ViewState& state);

}  // namespace roomgraph
