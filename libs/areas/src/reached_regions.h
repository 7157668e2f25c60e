#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/areas/area_graph.h"
#include "roomgraph/rooms/RoomGraph.h"

namespace roomgraph {

/** A Delaunay edge in which two regions meet, wide enough for the robot. */
bool isPassage(const VoronoiEdge& edge, const Regions& regions, double clearance);

/** Per region, non-zero where the graph reaches it. `traced` are the polygons of all regions. */
std::vector<std::uint8_t> reachedRegions(const ClearedSpace& space, const Rooms& traced,
                                         const RoomGraph& graph, double clearance);

}  // namespace roomgraph
