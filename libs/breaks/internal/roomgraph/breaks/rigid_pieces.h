#pragma once
#include <cstddef>

#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// After Schwertfeger and Birk (2015), "brokenness"; how the pieces are found is ours
// In:   FollowedWalls
// Out:  in how many rigid pieces a map lies in another
// Next: brokennessOf

struct RigidPiecesOptions {
  double reach = 4.5;      ///< between patches that may hold each other [m]
  double maxTurn = 0.02;   ///< between their poses, in one piece [rad]
  double maxShift = 0.2;   ///< and halfway between them [m]
  double minShare = 0.08;  ///< of the walls found, of a piece that counts
};

/** The number of pieces of a map that hold together in another: patches near by whose poses there
 *  are nearly the same are of one piece, so a map that bends bit by bit is one, and one that jumps
 *  is two. Small pieces do not count; 0 where nothing was followed. O(patches^2). */
std::size_t rigidPieces(const WallPatches& patches, const FollowedWalls& followed,
                        const RigidPiecesOptions& options);

}  // namespace roomgraph
