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

/** For each scan the median distance of its walls to the nearest wall that faces about the same way
 *  (within 60 degrees) of the scans that were taken beside its place, but at least 5 m of path
 *  earlier or later, all by the run's own poses: what the robot sees again must lie where it lay.
 *  The value is the 90th percentile over the scans [m], the support the number of scans that could
 *  be compared; no value without any. So it shows errors between two visits, not those of a way
 *  that was gone once. O(scans * (scans + walls^2)). */
Figure scanDisagreement(const std::vector<ScanWalls>& scans);

}  // namespace roomgraph
