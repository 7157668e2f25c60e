#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "roomgraph/voronoi/VoronoiGraph.h"
#include "roomgraph/voronoi/keep_clear.h"

namespace roomgraph {

// Ours: clutter parts no paths, as it parts no rooms
// In:   VoronoiGraph, the edges that are kept, and which of its obstacles are clutter
// Out:  the edges that are kept still
// Next: topologyGraph

/** Closes the narrowest of the passages round each piece of clutter, so that paths pass it on one
 *  side, the wider one, and no ladder of short paths grows among chairs. Of two passages as narrow
 *  as each other the longer one is closed; where these are equal, too, both stay, for then only the
 *  map's pose could decide. So do those round anything else, and round what touches places that
 *  are `isInRoom`: in a room, all paths become one vertex. What stays is connected as it was.
 *  `kept` ascends, and so does what comes back. O(n log n). */
EdgeIndices passClutter(const VoronoiGraph& voronoi, EdgeIndices kept,
                        const std::vector<std::uint8_t>& isClutter,
                        const std::function<bool(Point)>& isInRoom);

}  // namespace roomgraph
