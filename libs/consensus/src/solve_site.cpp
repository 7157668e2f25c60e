#include "roomgraph/consensus/solve_site.h"

#include <utility>

#include "roomgraph/base/return_memory.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {

std::vector<Transform2D> SolvedSite::posesOf(std::size_t run) const {
  std::vector<Transform2D> poses;
  for (const NodeId node : consensus.nodesOf(run)) poses.push_back(consensus.poses[node]);
  return poses;
}

SolvedSite solveSite(const std::vector<Run>& runs, const MapPairs& related,
                     std::optional<std::size_t> reference, const ForEach& forEach) {
  Site site = placeRuns(runs, related, reference);
  MapPairs pairs = pairsInSite(site, related, forEach);
  PairBends bends = bendsOf(pairs);
  DistinctMaps maps(bends);
  Consensus consensus = siteConsensus(site, pairs, maps, forEach);
  returnMemory();  // of hundreds of runs, what it is worked out from is much
  return {std::move(site), std::move(pairs), std::move(bends), std::move(maps),
          std::move(consensus)};
}

}  // namespace roomgraph
