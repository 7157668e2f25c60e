#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/consensus/RunMatches.h"

namespace roomgraph {

/** First poses of all submaps where no run is torn: each run lies as a whole (site <- run) where
 *  most of all matches agree, of the places where one of its pieces would have it. The reference,
 *  if any, stays where it is. A run that nothing was found of keeps its own poses. Deterministic.
 *  O(rounds * pieces * matches of a run). */
SubmapPoses wholePoses(const std::vector<RunSubmaps>& runs, const std::vector<RunMatches>& matches,
                       std::optional<std::size_t> reference);

}  // namespace roomgraph
