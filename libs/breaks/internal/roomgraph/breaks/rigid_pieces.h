#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// After Schwertfeger and Birk (2015), "brokenness"; how the pieces are found is ours
// In:   FollowedWalls
// Out:  in how many rigid pieces a map lies in another
// Next: brokennessOf, findPieces

struct RigidPiecesOptions {
  double reach = 4.5;      ///< between patches that may hold each other [m]
  double maxTurn = 0.02;   ///< between their poses, in one piece [rad]
  double maxShift = 0.2;   ///< and halfway between them [m]
  double minShare = 0.08;  ///< of the walls found, of a piece that counts
};

/** Patches that hold together, as indices of `followed.patches`, ascending: those that are near by
 *  and whose poses in the other map are nearly the same, and so on from one to the next. So a map
 *  that bends bit by bit is one piece, and one that jumps is two. Most walls first; without those
 *  that are too small to count. O(patches * patches within reach). */
std::vector<std::vector<std::size_t>> piecesThatHold(const WallPatches& patches,
                                                     const FollowedWalls& followed,
                                                     const RigidPiecesOptions& options);

/** How many of them there are; 0 where nothing was followed. */
std::size_t rigidPieces(const WallPatches& patches, const FollowedWalls& followed,
                        const RigidPiecesOptions& options);

}  // namespace roomgraph
