#pragma once
#include <vector>

#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

// In:   a map drawn with the levels of FloorPlan.h
// Out:  the part of it that a robot with a laser would know

/** Sets to unknown what cannot be seen from any of `places` (which lie on the map) within `range`
 *  cells. Whole numbers only, so that the bytes are the same everywhere. O(places * range^2). */
GreyMap keepSeen(const GreyMap& map, const std::vector<Point>& places, int range);

}  // namespace roomgraph
