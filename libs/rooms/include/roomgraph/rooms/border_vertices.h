#pragma once
#include <vector>

#include "roomgraph/rooms/Room.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Paper III-C
// In:   TopologyGraph, Rooms
// Out:  PathStretches
// Next: cutPaths

/** A stretch of a path that lies in one room, or in none. */
struct Stretch {
  double from = 0, to = 0;  ///< distance from the path's source [m]
  RoomId room;              ///< none for a corridor
};

/** The stretches of each edge's path in their order, without gaps: where one ends and the next
 *  starts the path crosses a room's polygon, and a border vertex belongs there. */
using PathStretches = std::vector<std::vector<Stretch>>;

/** Where the paths cross the rooms' polygons, decided exactly for the given coordinates (CGAL). A
 *  touch that does not change the room is no crossing; a stretch not longer than `epsilon` is none.
 *  `clearance` must be that of all paths: only polygon edges longer than twice of it can be
 *  crossed. O(path points * log n) where the long polygon edges are spread over the map. */
[[nodiscard]] PathStretches borderVertices(const TopologyGraph& graph, const Rooms& rooms,
                                           double clearance, double epsilon);

}  // namespace roomgraph
