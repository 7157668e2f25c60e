#pragma once
#include "roomgraph/base/Notes.h"
#include "roomgraph/base/Options.h"
#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/rooms/RoomGraph.h"

namespace roomgraph {

// Paper III-G
// In:   TopologyGraph with rooms cut out, Rooms
// Out:  RoomGraph
// Next: areaGraph

struct RoomGraphOptions {
  /** Straight edges from the centroid, whatever lies between, as the paper draws them. */
  bool straightEdges = false;
  double robotWidth = 0.5;  ///< of the ways inside of rooms; see innerWays [m]
};
void describe(RoomGraphOptions& options, FieldTable& table);

/** Takes all paths and vertices inside of the rooms out, and puts one vertex into each room.
 *
 *  Where the ways through a room tell something (loops round shelves, aisles, places: innerWays),
 *  they stay, with the room's vertex at the place nearest to the centroid on them. Any other, plain
 *  room becomes a star of edges from its vertex to its border vertices. The vertex stands at the
 *  centroid, and its edges are straight, where each of these keeps inside of the polygon and
 *  `clearance` from all obstacles. Elsewhere (concave, or with a table in the middle) it stands at
 *  the place nearest to the centroid on the paths through the room, and its edges follow the
 *  shortest of those. Halls get straight ways across their open floor as well (hallWays). With
 *  `straightEdges` each room is a star. A room that the graph does not enter is left out and told
 *  in `notes` (code "room_unreached"); one without a way in it becomes a vertex without edges. Room
 *  ids are numbered anew, in the order of `rooms`. O(n log n), and see hallWays. */
[[nodiscard]] RoomGraph roomGraph(const TopologyGraph& graph, const Rooms& rooms,
                                  const ObstacleRows& obstacles, double clearance,
                                  const RoomGraphOptions& options, Notes& notes);

}  // namespace roomgraph
