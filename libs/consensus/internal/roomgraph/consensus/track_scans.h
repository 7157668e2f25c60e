#pragma once
#include <optional>
#include <vector>

#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/WallMap.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// Ours
// In:   the scans of a run, and another map
// Out:  where each scan lies in that map
// Next: matchSubmaps

struct TrackScansOptions {
  NarrowingBand band{0.6, 0.2, 6};  ///< around a wall, of what counts in the fit of a scan
  double near = 0.1;                ///< a wall this far from another counts half [m]
  double sureQuality = 0.75;        ///< from which on no other pose is tried
  double minQuality = 0.45;         ///< share of a scan's walls that must be found
  double lostQuality = 0.45;        ///< worth of a scan that is not found
  double jumpCost = 2;              ///< of a jump where the robot goes on from where it was
  double farCost = 20;              ///< of a jump to another place
  double stride = 2.5;              ///< longest way from scan to scan [m]
  std::size_t memory = 8;           ///< scans that may be lost between two that are found
  std::size_t candidates = 4;       ///< of a scan
  double spinQuality = 0.6;         ///< a scan found less well is looked for at any turn
  double reach = 6;                 ///< patches within this give poses to try [m]
};

/** For each scan its pose (in <- run) in the map `in`, none where it is not found there: the
 *  likeliest way of all scans through that map (Viterbi 1967). A scan is looked for where the
 *  scans before and behind it lie, where the run's patches near by were `followed`, where the run
 *  may lie as a whole by one of `wholes` (in <- run, at least one, the likeliest first), and, where
 *  that fails, at any turn where the robot has just been, as a map that is torn goes on from the
 *  same place. A way that begins far from the first of `wholes` costs as much as two jumps.
 *  Deterministic. O(scans * candidates * walls of a scan). */
std::vector<std::optional<Transform2D>> trackScans(
    const std::vector<ScanWalls>& scans, const WallPatches& patches, const FollowedWalls& followed,
    const std::vector<Transform2D>& wholes, const WallMap& in, const TrackScansOptions& options);

}  // namespace roomgraph
