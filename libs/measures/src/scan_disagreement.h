#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/measures/Figure.h"

namespace roomgraph {

// Ours: what a run tells of itself, without any other
// In:   the scans of a run
// Out:  how far they lie from what the run saw at another time
// Next: scanDisagreementOf

struct ScanDisagreementOptions {
  double minApart = 5;        ///< path between two scans that are compared [m]
  double sameView = 2;        ///< between the places of two scans that see the same [m]
  std::size_t mostScans = 8;  ///< that one is compared with, nearest first
  double reach = 1;           ///< of the nearest wall [m]
  double spacing = 0.15;      ///< along a wall, which is no distance [m]
  double minShare = 0.5;      ///< of a scan's walls that must have a wall in reach
  std::size_t minWalls = 10;  ///< of these
  double quantile = 0.9;      ///< over the scans
};

/** For each scan the median distance of its walls to the nearest wall that faces about the same way
 *  (within 60 degrees) of the scans that were taken beside its place, but at least minApart of path
 *  earlier or later, all by the run's own poses: what the robot sees again must lie where it lay.
 *  The value is the 90th percentile over the scans [m], the support the number of scans that could
 *  be compared; no value without any. So it shows errors between two visits, not those of a way
 *  that was gone once. O(scans * (scans + mostScans * walls^2)). */
Figure scanDisagreement(const std::vector<ScanWalls>& scans,
                        const ScanDisagreementOptions& options);

}  // namespace roomgraph
