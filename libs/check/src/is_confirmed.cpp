#include "is_confirmed.h"

#include <algorithm>

#include "roomgraph/align/near_poses.h"

namespace roomgraph {
namespace {

constexpr std::size_t kLeastAcross = 2;  // revisits that fit, from one side of a break to the other
constexpr std::size_t kFitsPerMiss = 2;  // revisits that fit for each that does not

}  // namespace

bool isConfirmed(const SelfConsensus& consensus, const std::vector<std::size_t>& breaks) {
  std::vector<std::size_t> across(breaks.size(), 0);
  std::size_t fits = 0;
  for (const PoseEdge& edge : consensus.revisits) {
    const std::size_t from = edge.from.index(), to = edge.to.index();
    const Transform2D found = consensus.poses[from].inverse() * consensus.poses[to];
    if (!areNear(edge.measured, found, {}, kNextPatch)) continue;
    ++fits;
    for (std::size_t i = 0; i < breaks.size(); ++i)
      if (std::min(from, to) < breaks[i] && breaks[i] <= std::max(from, to)) ++across[i];
  }
  return fits > kFitsPerMiss * (consensus.revisits.size() - fits) &&
         std::all_of(across.begin(), across.end(),
                     [](std::size_t count) { return count >= kLeastAcross; });
}

}  // namespace roomgraph
