#pragma once
#include <optional>
#include <vector>

#include "roomgraph/align/MapForAlignment.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// Ours
// In:   the scans of a run, and another map
// Out:  where each scan lies in that map
// Next: findBreaks

struct TrackScansOptions {
  double firstWidth = 0.6;    ///< of the band around a wall that counts at first [m]
  double lastWidth = 0.2;     ///< and at last [m]
  int iterations = 6;         ///< of the fit of a scan
  double near = 0.1;          ///< how far apart the same wall lies [m]
  double sureQuality = 0.75;  ///< from which on no other pose is tried
  double minQuality = 0.45;   ///< share of a scan's walls that must be found
  double margin = 0.05;       ///< by which a pose must be better than that of the scan before
  double reach = 6;           ///< patches within this give poses to try [m]
};

/** For each scan its pose (in <- run) by its own walls alone, none where it is not found in `in`.
 *  From scan to scan the pose goes on from the one before, or from what was `followed` of the run's
 *  patches near by where that fits better. O(scans * patches near by * walls). */
std::vector<std::optional<Transform2D>> trackScans(const std::vector<ScanWalls>& scans,
                                                   const WallPatches& patches,
                                                   const FollowedWalls& followed,
                                                   const MapForAlignment& in,
                                                   const TrackScansOptions& options);

}  // namespace roomgraph
