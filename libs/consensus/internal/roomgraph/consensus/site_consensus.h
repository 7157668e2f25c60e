#pragma once
#include <optional>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/DistinctMaps.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   the runs of a site, how each two of them lie in each other, and which are copies
// Out:  Consensus
// Next: scoreRuns, siteBreaks

/** Matches the nodes of all runs of a site that were related, and finds their consensus: that of
 *  the core, to which the other runs are added one by one. Of copies of one map one counts. A
 *  reference, which is in the core, is taken for the truth. The site's poses say how each run
 *  lies in each other as a whole. Nothing is found of runs of which none has scans. The same for
 *  any order of the jobs. Cost: that of matchNodes for each pair, both ways, and that of
 *  findConsensus. */
Consensus siteConsensus(const Site& site, const MapPairs& pairs, const DistinctMaps& maps,
                        const ForEach& forEach);

/** All that several runs together tell of where everything lies. */
struct SolvedSite {
  Site site;
  MapPairs pairs;   ///< of the runs of the site
  PairBends bends;  ///< of those
  DistinctMaps maps;
  Consensus consensus;
};

/** placeRuns, pairsInSite, siteConsensus and refinePoses, one after the other. `runs` must outlive
 *  the result, which names them. Cost: theirs. */
SolvedSite solveSite(const std::vector<Run>& runs, const MapPairs& related,
                     std::optional<std::size_t> reference, const ForEach& forEach);

}  // namespace roomgraph
