#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ViewState.h"

namespace roomgraph {

/** What there is to say of a place [m, frame of the site, or of the one map]: a line each for the
 *  place, the room, the nearest vertex and path of the graph, and the nearest key frame. */
std::vector<std::string> readPlace(const View& view, const ViewState& state, Point place);

/** What there is to say of the run, its key frame, the fault that is looked at, and of what the
 *  mouse is for. */
std::vector<std::string> readState(const View& view, const ViewState& state);

/** The room of the ledger that holds a place; null for none. */
const SiteRoom* siteRoomAt(const View& view, Point place);

/** Of the one map's graph: the room that holds a place, and the path that is nearest to it, where
 *  no vertex is as near. None without a graph, and where there is nothing within a metre. */
std::optional<std::size_t> roomAt(const View& view, Point place);
std::optional<std::size_t> pathNear(const View& view, Point place);

}  // namespace roomgraph
