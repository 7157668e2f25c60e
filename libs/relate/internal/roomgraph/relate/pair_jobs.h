#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "roomgraph/align/FullMaps.h"
#include "roomgraph/base/ForEach.h"
#include "roomgraph/base/PairTable.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

/** Pairs as jobs for a ForEach, by their places among `pairs`: those of one bare map together, so
 *  that it is completed once for all of them; of others each by itself. In the order of the pairs
 *  that come first. O(pairs * log pairs). */
std::vector<std::vector<std::size_t>> pairJobs(const std::vector<PairOfThings>& pairs,
                                               const std::function<bool(std::size_t)>& isBare);

/** Calls `visit` with the place of each of some pairs of a site among them, and with what completes
 *  the maps of its runs; in jobs as above. */
void visitPairs(const Site& site, const std::vector<PairOfThings>& pairs, const ForEach& forEach,
                const std::function<void(std::size_t, FullMaps&)>& visit);

}  // namespace roomgraph
