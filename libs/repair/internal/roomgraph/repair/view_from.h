#pragma once
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/WallMap.h"

namespace roomgraph {

// Ours
// In:   a map, and a place on it
// Out:  LocalScan
// Next: carryPlaces

/** What a robot would see at a place by a map: the walls up to `range` [m] from it that face it and
 *  that no other wall hides, in the frame of the place (`at`: map <- place). None where the map
 *  knows nothing. O(walls + walls in range * cells to them). */
LocalScan viewFrom(const WallMap& map, const Transform2D& at, double range);

}  // namespace roomgraph
