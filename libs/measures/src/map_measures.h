#pragma once
#include <optional>
#include <vector>

#include "roomgraph/measures/Measure.h"
#include "roomgraph/relate/Site.h"
#include "roomgraph/relate/relate_runs.h"

namespace roomgraph {

// Ours
// In:   a run, alone or among the others
// Out:  Measure
// Next: compareRuns

/** Of one run by itself: `wall_doubling`, see wallDoubling [share]; `wall_sharpness`, see
 *  wallSharpness [cells per cell]; `scan_disagreement`, see scanDisagreement [m], without a value
 *  where there are no scans. No intervals, as the others have no part in it. Meaningful with 300
 *  wall points, or with 10 scans that could be compared. */
std::vector<Measure> ownMeasuresOf(const Run& run);

/** Of one run: `brokenness`, the number of its rigid pieces less 1. With scans it is `breaks`, the
 *  number of breaks that were found along them (support: scans; none without another run). Without
 *  scans it is the median of rigidPieces in the others, weighted by trust, over those in which 30 %
 *  of its walls were found (support: wall points found). */
Measure brokennessOf(const Site& site, const MapPairs& pairs, const Trust& trust, std::size_t run,
                     std::size_t breaks);

}  // namespace roomgraph
