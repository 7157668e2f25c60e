#pragma once
#include <cstddef>
#include <vector>

#include "MeasuredValue.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   a run, alone or among the others
// Out:  MeasuredValue
// Next: measureSite

/** Of one run by itself: see wallDoubling [share] and wallSharpness [cells per cell]. No intervals,
 *  as the others have no part in it. */
MeasuredValue wallDoublingOf(const Run& run);
MeasuredValue wallSharpnessOf(const Run& run);

/** Of one run: `brokenness`, the number of its rigid pieces less 1. With scans it is `breaks`, the
 *  number of breaks that were found along them (support: scans; none without another run). Without
 *  scans it is the median of rigidPieces in the others, weighted by trust, over those in which 30 %
 *  of its walls were found (support: wall points found). */
MeasuredValue brokennessOf(const Site& site, const MapPairs& pairs, const Trust& trust,
                           std::size_t run, std::size_t breaks);

/** For each scan the median distance of its walls to the nearest wall that faces about the same way
 *  (within 60 degrees) of the scans that were taken beside its place, but at least 5 m of path
 *  earlier or later, all by the run's own poses: what the robot sees again must lie where it lay.
 *  The value is the 90th percentile over the scans [m], the support the number of scans that could
 *  be compared; no value without any. So it shows errors between two visits, not those of a way
 *  that was gone once. O(scans * (scans + walls^2)). */
MeasuredValue scanDisagreement(const std::vector<ScanWalls>& scans);

}  // namespace roomgraph
