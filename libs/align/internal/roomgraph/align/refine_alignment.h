#pragma once
#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// Ours, after the usual iterated closest points
// In:   a pose that is nearly right
// Out:  the pose that lays the walls over each other
// Next: verifyAlignment

struct RefineAlignmentOptions {
  NarrowingBand band{0.6, 0.25, 12};  ///< around a wall, of what counts
  int maxPoints = 400;                ///< wall points of a map that are looked up
};

/** Moves `b` so that walls that face the same way come to lie on each other, both maps' wall points
 *  being looked up in the other map. Distances count across the wall, far ones little, so parts
 *  that fit well win over parts that do not. Where nothing is in reach, or nothing holds the pose
 *  in a direction, it stays as it is. O(steps * points). */
Transform2D refineAlignment(const WallMap& a, const WallMap& b, const Transform2D& pose,
                            const RefineAlignmentOptions& options);

}  // namespace roomgraph
