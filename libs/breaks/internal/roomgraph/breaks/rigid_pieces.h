#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/near_poses.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// After Schwertfeger and Birk (2015), "brokenness"; how the pieces are found is ours
// In:   FollowedWalls
// Out:  the rigid pieces in which a map lies in another
// Next: brokennessOf, findPieces

constexpr double kPieceReach = 4.5;   ///< between patches that may hold each other [m]
constexpr double kLeastPiece = 0.08;  ///< of the walls found, of a piece that counts

/** Patches that hold together, as indices of `followed.patches`, ascending: those that are near by
 *  and whose poses in the other map are kSameScanAnswer, and so on from one to the next.
 *  So a map that bends bit by bit is one piece, and one that jumps is two. Most walls first;
 *  without those that are too small to count; none where nothing was followed.
 *  O(patches * patches within reach). */
std::vector<std::vector<std::size_t>> rigidPieces(const WallPatches& patches,
                                                  const FollowedWalls& followed);

}  // namespace roomgraph
