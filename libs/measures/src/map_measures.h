#pragma once
#include "MeasuredValue.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   a run, alone or among the others
// Out:  MeasuredValue
// Next: measureSite

/** Of one run by itself: see wallDoubling [share], wallSharpness [cells per cell] and
 *  scanDisagreement [m], which has no value where there are no scans. No intervals, as the others
 *  have no part in it. */
MeasuredValue wallDoublingOf(const Run& run);
MeasuredValue wallSharpnessOf(const Run& run);
MeasuredValue scanDisagreementOf(const Run& run);

/** Of one run: `brokenness`, the number of its rigid pieces less 1. With scans it is `breaks`, the
 *  number of breaks that were found along them (support: scans; none without another run). Without
 *  scans it is the median of rigidPieces in the others, weighted by trust, over those in which 30 %
 *  of its walls were found (support: wall points found). */
MeasuredValue brokennessOf(const Site& site, const MapPairs& pairs, const Trust& trust,
                           std::size_t run, std::size_t breaks);

}  // namespace roomgraph
