#pragma once
#include <functional>
#include <string>

#include "roomgraph/rooms/RoomGraph.h"

namespace roomgraph::test {

/** Whether `b` is `a` in another pose: `aToB` maps a's places to b's. Vertices are matched one to
 *  one by kind and place, edges by their matched ends, kind and path, rooms by their vertex, border
 *  vertices, holes and area. `tolerance` [m] is for places and paths. Ring vertices stand anywhere
 *  on their ring. Returns one line about the first difference; empty where there is none. */
std::string differenceOfGraphs(const RoomGraph& a, const RoomGraph& b,
                               const std::function<Point(Point)>& aToB, double tolerance);

}  // namespace roomgraph::test
