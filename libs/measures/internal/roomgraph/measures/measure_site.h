#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/base/PairTable.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/measures/Measure.h"
#include "roomgraph/relate/DistinctMaps.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {

// Ours, and after Schwertfeger and Birk (2015)
// In:   the runs of a site, how they lie in each other, whom to trust, and where runs break
// Out:  Measure of each run and pair
// Next: summarize

/** The measures of a site, see docs/scoring.md. */
struct SiteMeasures {
  std::vector<std::vector<Measure>> runs;  ///< of each run; the same ones, in the same order
  PairTable<std::vector<Measure>> pairs;   ///< of each pair that was related, alike
};

/** Measures all runs and pairs. `bends` are those of `pairs`, `maps` says which runs are copies,
 *  `trust` whom to trust on where things are and `witnesses` on what there is, and `breaks` are
 *  those of each run.
 *  O(pairs * (walls + cells of the site + compareGraphs)). */
SiteMeasures measureSite(const Site& site, const MapPairs& pairs, const PairBends& bends,
                         const DistinctMaps& maps, const Trust& trust, const Trust& witnesses,
                         const std::vector<std::vector<MapBreak>>& breaks, const ForEach& forEach);

}  // namespace roomgraph
