#pragma once
#include "roomgraph/rooms/cut_paths.h"
#include "roomgraph/rooms/room_ids.h"
#include "square_rooms.h"

namespace roomgraph::test {

/** The graph cut at the rooms' polygons, with room ids. */
inline TopologyGraph cutAtRooms(const TopologyGraph& graph, const Rooms& rooms) {
  const PathStretches stretches = borderVertices(graph, rooms, kClearance, kEpsilon);
  return roomIds(cutPaths(graph, stretches), rooms);
}

}  // namespace roomgraph::test
