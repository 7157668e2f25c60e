#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// Ours: a map bends, so each of its patches has a pose of its own
// In:   two maps, and poses of the one in the other
// Out:  FollowedWalls
// Next: scoreRuns, findBreaks

/** The layer of walls that lie where the other map shows free space, and were found elsewhere. */
constexpr int kTornLayer = 100;

/** A patch of walls that was found in the other map. */
struct FollowedPatch {
  std::uint32_t patch = 0;  ///< of WallMap::patches
  Transform2D pose;         ///< other <- map, right near the patch's middle
  double walls = 0;         ///< wall points of its own that lie on walls there
  int layer = 0;            ///< where a patch was mapped twice, each copy has a layer
};

/** Where the walls of one map lie in another, place by place. */
struct FollowedWalls {
  std::vector<FollowedPatch> patches;  ///< as they were found: surest first within a layer
  Transform2D pose;                    ///< other <- map, that fits all of them best
  double bend = 0;   ///< root mean square displacement of the walls that `pose` leaves over [m]
  double share = 0;  ///< of the walls that were found, 0 to 1
  /** Root mean square distance, at `pose`, of all walls whose place the other map has seen to those
   *  there; each is at most 1 m [m]. */
  double misfit = 0;
};

/** So far from the middle of a patch its pose tells where things are, and so far round a place its
 *  surroundings tell where it is [m]. */
constexpr double kPatchReach = 6;

/** Walls are followed up to so far away from where the first pose has them [m]. */
constexpr double kMaxBend = 60;

/** Looks for each patch of `map` in `other`, starting where the first of `poses` (other <- map)
 *  fits and growing from patch to patch, surest first, so that the pose can change as the maps
 *  bend. What is left over is looked for again: with the other poses, as a broken map has pieces,
 *  and next to what was found, as walls can be there twice. A place that looks alike may be found
 *  so, too. Of maps without scans, a short end that is torn off is looked for as a whole where the
 *  other map contradicts it, and has the layer kTornLayer. Nothing is found where there is no
 *  pose. A map followed in itself from where it lies hardly bends.
 *
 *  Deterministic. O(patches * points of a patch), and 0.1 s where walls are contradicted. */
FollowedWalls followWalls(const WallMap& map, const WallMap& other,
                          const std::vector<Transform2D>& poses);

}  // namespace roomgraph
