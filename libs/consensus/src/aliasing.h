#pragma once
#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** How far a motion (map <- map) lays a map on itself: of its patches of walls that come to lie
 *  where the map has looked, the share that finds walls there, each after a fit of its own, as maps
 *  bend; 0 to 1. 0 where too few come to lie there. O(patches looked at, 80 at most). */
double aliasingUnder(const Transform2D& motion, const WallMap& map);

}  // namespace roomgraph
