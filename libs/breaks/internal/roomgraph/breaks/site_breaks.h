#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/breaks/ScanBreak.h"
#include "roomgraph/consensus/site_consensus.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {

// In:   the runs of a site, how each two of them lie in each other, their consensus, whom to trust
// Out:  MapBreak
// Next: measureSite, summarize

/** Share of a run's walls that another run must have, to tell where it breaks. */
constexpr double kWitnessShare = 0.3;

/** The breaks of each run of the site, along it. Of a run with scans: where the consensus has
 *  torn it from one scan to the next. Of one without: where it has the same two pieces in
 *  most of the maps that are trusted most and know both, by their votes.
 *  O(runs * (scans + patches^2)). */
std::vector<std::vector<MapBreak>> siteBreaks(const Site& site, const MapPairs& pairs,
                                              const Consensus& consensus, const Trust& trust,
                                              const FindBreaksOptions& options,
                                              const ForEach& forEach);

}  // namespace roomgraph
