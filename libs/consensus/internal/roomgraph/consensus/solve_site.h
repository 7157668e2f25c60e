#pragma once
#include <optional>
#include <vector>

#include "roomgraph/consensus/site_consensus.h"

namespace roomgraph {

// Ours
// In:   runs, and how each two of them lie in each other
// Out:  SolvedSite
// Next: repairRuns, mergeRuns, carryPlaces

/** All that several runs together tell of where everything lies. */
struct SolvedSite {
  Site site;
  MapPairs pairs;   ///< of the runs of the site
  PairBends bends;  ///< of those
  DistinctMaps maps;
  Consensus consensus;

  /** Where the scans of a run of the site really lie, or its patches: site <- node. */
  std::vector<Transform2D> posesOf(std::size_t run) const;
};

/** placeRuns, pairsInSite and siteConsensus, one after the other. `runs` must outlive the result,
 *  which names them. Cost: theirs. */
SolvedSite solveSite(const std::vector<Run>& runs, const MapPairs& related,
                     std::optional<std::size_t> reference, const ForEach& forEach);

}  // namespace roomgraph
