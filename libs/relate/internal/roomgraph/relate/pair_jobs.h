#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "roomgraph/base/PairTable.h"

namespace roomgraph {

/** Pairs as jobs for a ForEach, by their places among `pairs`: those of one bare map together, so
 *  that it is completed once for all of them; of others each by itself. In the order of the pairs
 *  that come first. O(pairs * log pairs). */
std::vector<std::vector<std::size_t>> pairJobs(const std::vector<PairOfThings>& pairs,
                                               const std::function<bool(std::size_t)>& isBare);

}  // namespace roomgraph
