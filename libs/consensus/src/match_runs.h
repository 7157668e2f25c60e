#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/consensus/match_nodes.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   Site, MapPairs, PoseGraph without matches
// Out:  FoundGroup
// Next: findConsensus, addToConsensus

/** All matches between the runs of a graph that were related; `siteRuns` says which of the site
 *  they are. Ordered by the runs. Cost: that of matchNodes for each pair, both ways. */
std::vector<FoundGroup> matchRuns(const Site& site, const MapPairs& pairs, const PoseGraph& graph,
                                  const ById<RunId, std::size_t>& siteRuns, const ForEach& forEach);

/** The same once it is known where the nodes lie, by matchAgain. */
std::vector<FoundGroup> matchRunsAgain(const Site& site, const MapPairs& pairs,
                                       const Consensus& consensus, const ForEach& forEach);

}  // namespace roomgraph
