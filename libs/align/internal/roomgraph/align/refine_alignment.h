#pragma once
#include "roomgraph/align/Look.h"
#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// Ours, after the usual iterated closest points
// In:   a pose that is nearly right
// Out:  the pose that lays the walls over each other
// Next: verifyAlignment

/** Moves `b` so that walls that face the same way come to lie on each other, both maps' wall points
 *  being looked up in the other map. Distances count across the wall, far ones little, so parts
 *  that fit well win over parts that do not. Where nothing is in reach, or nothing holds the pose
 *  in a direction, it stays as it is. O(steps * points). */
Transform2D refineAlignment(const WallMap& a, const WallMap& b, const Transform2D& pose,
                            const Look& look = kCloseLook);

}  // namespace roomgraph
