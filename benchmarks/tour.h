#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/geometry/Point.h"
#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

// In:   a complete map drawn with the levels of FloorPlan.h
// Out:  the corners of a way that sees all of it
// Next: walk

/** A closed way from a random place through all free space that a robot 0.6 m wide can reach from
 *  there: always on to the nearest place that is not within 3 m of the way yet. The same seed gives
 *  the same way. Empty where no place is wide enough. O(cells * places). */
std::vector<Point> tour(const GreyMap& map, std::uint32_t seed);

}  // namespace roomgraph
