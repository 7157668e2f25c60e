#pragma once
#include <vector>

#include "roomgraph/consensus/site_consensus.h"
#include "roomgraph/relate/DistinctMaps.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   the runs of a site, and how far each two of them bend apart
// Out:  MapError of each run
// Next: scoreRuns

/** The map errors of all runs of a site from the bends of their maps alone, for runs without scans:
 *  one estimate for all copies of a map. Edits of one picture are one voice among the others, but
 *  each has an error of its own, in the place of that voice. `seen` is the largest share of walls
 *  in common with another map, 0 for a run that has none. Cost: that of estimateMapErrors, for
 *  each edit. */
std::vector<MapError> errorsByBends(const Site& site, const PairBends& bends,
                                    const DistinctMaps& maps);

/** The map error of each run of a site: that of the consensus where all runs have scans, else that
 *  of errorsByBends, as patches of walls alone make a poor pose graph. What others confirm of a run
 *  without scans are the patches that were found in one of them about where the whole lies there;
 *  of one with scans the consensus tells it, and the jitter. O(patches * runs^2) beside
 *  errorsByBends. */
std::vector<MapError> siteErrors(const Site& site, const MapPairs& pairs, const PairBends& bends,
                                 const DistinctMaps& maps, const Consensus& consensus);

}  // namespace roomgraph
