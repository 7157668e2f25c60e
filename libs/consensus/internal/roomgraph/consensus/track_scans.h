#pragma once
#include <optional>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// In:   the scans of a run, and another map
// Out:  where each scan lies in that map
// Next: matchNodes

/** What a scan comes to from a start, roughly and, where that is worth it, to the end (in <- run);
 *  and how well it lies there. */
struct TrackedFit {
  Transform2D start, rough, pose;
  double roughQuality = 0;
  std::optional<double> quality;  ///< at `pose`, once that was looked for
};

using TrackedFits = std::vector<std::vector<TrackedFit>>;  ///< of each scan

/** Where a run may lie in another map (in <- run). */
struct LikelyPoses {
  std::vector<Transform2D> whole;  ///< the run as a whole, the likeliest first; at least one
  std::vector<Transform2D> lost;   ///< stretches that were not found, see lookAgain
};

/** For each scan its pose (in <- run) in the map `in`, none where it is not found there: the
 *  likeliest way of all scans through that map (Viterbi 1967). A scan is looked for where the
 *  scans before and behind it lie, where the run's patches near by were `followed`, where it is
 *  `likely`, and, where that fails, at any turn where the robot has just been, as a map that is
 *  torn goes on from the same place. A way that begins far from the likeliest pose of the whole
 *  costs as much as two jumps; a jump to where a lost stretch may lie costs less, the less the
 *  run's own scans hold together there.
 *  It takes from `fits` what earlier calls for the same scans and map found, and adds what it
 *  finds: with a few more likely poses little is left to do. Deterministic.
 *  O(scans * candidates * walls of a scan). */
std::vector<std::optional<Transform2D>> trackScans(const std::vector<ScanWalls>& scans,
                                                   const WallPatches& patches,
                                                   const FollowedWalls& followed,
                                                   const LikelyPoses& likely, const WallMap& in,
                                                   TrackedFits& fits);

}  // namespace roomgraph
