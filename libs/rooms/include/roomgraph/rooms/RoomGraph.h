#pragma once
#include <vector>

#include "roomgraph/base/Ids.h"
#include "roomgraph/rooms/Room.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

/** One room of the result. */
struct GraphRoom {
  Room shape;                            ///< its outline and area
  Point center;                          ///< where its vertex stands [m, map frame]
  VertexId vertex;                       ///< of kind room
  std::vector<VertexId> borderVertices;  ///< ascending; empty for a room without a way out
};

/** The result: a topology graph in which each room has a vertex of its own, and is left through its
 *  border vertices (paper III-G). Edges with a room id run inside that room: in a plain one from
 *  its vertex to each border vertex; in one with aisles and islands along these, with junctions and
 *  dead ends of their own, which have the room's id, too. All other edges are corridors. RoomIds
 *  index `rooms`; a border vertex in a door between two rooms carries the smaller id and is listed
 *  by both. */
struct RoomGraph {
  TopologyGraph graph;           ///< with a vertex for each room
  std::vector<GraphRoom> rooms;  ///< by RoomId
};

}  // namespace roomgraph
