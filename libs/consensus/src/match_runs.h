#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/RunMatches.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   Site, MapPairs, RunSubmaps of each run
// Out:  RunMatches
// Next: findConsensus, addToConsensus

/** All matches between the runs named in `order` that were related, by their places there;
 *  `submaps` are theirs. Ordered by those places. Cost: that of matchSubmaps for each pair, both
 *  ways. */
std::vector<RunMatches> matchRuns(const Site& site, const MapPairs& pairs,
                                  const std::vector<std::size_t>& order,
                                  const std::vector<RunSubmaps>& submaps, const ForEach& forEach);

}  // namespace roomgraph
