#pragma once
#include "roomgraph/rooms/Room.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Paper III-E
// In:   TopologyGraph, cut at the border vertices
// Out:  the same with room ids on all vertices and paths
// Next: removeShortDeadEnds

/** Every vertex inside of a room gets its id. A vertex where paths of a room meet others lies on
 *  the polygon: it becomes a border vertex (III-D, case A: the cut falls on a source or target).
 *  O(n). */
[[nodiscard]] TopologyGraph roomIds(TopologyGraph graph, const Rooms& rooms);

}  // namespace roomgraph
