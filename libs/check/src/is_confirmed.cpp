#include "is_confirmed.h"

#include <algorithm>

namespace roomgraph {

bool isConfirmed(const SelfConsensus& consensus, const std::vector<std::size_t>& breaks) {
  std::vector<std::size_t> across(breaks.size(), 0);
  std::size_t fits = 0;
  for (const PoseEdge& edge : consensus.revisits) {
    const std::size_t from = edge.from.index(), to = edge.to.index();
    if (!isBorneOut(edge, consensus.poses)) continue;
    ++fits;
    for (std::size_t i = 0; i < breaks.size(); ++i)
      if (std::min(from, to) < breaks[i] && breaks[i] <= std::max(from, to)) ++across[i];
  }
  return fits > kFitsPerMiss * (consensus.revisits.size() - fits) &&
         std::all_of(across.begin(), across.end(),
                     [](std::size_t count) { return count >= kLeastAcross; });
}

}  // namespace roomgraph
