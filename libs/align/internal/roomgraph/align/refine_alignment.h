#pragma once
#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// Ours, after the usual iterated closest points
// In:   a pose that is nearly right
// Out:  the pose that lays the walls over each other
// Next: verifyAlignment

/** For a pose that is to be as good as it can be. */
constexpr NarrowingBand kFineBand{0.6, 0.25, 12};
constexpr int kFinePoints = 400;

/** Moves `b` so that walls that face the same way come to lie on each other, both maps' wall points
 *  being looked up in the other map. Distances count across the wall, far ones little, so parts
 *  that fit well win over parts that do not. Where nothing is in reach, or nothing holds the pose
 *  in a direction, it stays as it is. Of each map at most `maxPoints` wall points are looked up,
 *  evenly. O(steps * points). */
Transform2D refineAlignment(const WallMap& a, const WallMap& b, const Transform2D& pose,
                            const NarrowingBand& band = kFineBand, int maxPoints = kFinePoints);

}  // namespace roomgraph
