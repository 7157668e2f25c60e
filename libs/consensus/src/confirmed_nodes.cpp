#include "confirmed_nodes.h"

#include "fitted_consensus.h"
#include "roomgraph/base/majority.h"
#include "roomgraph/consensus/belief.h"

namespace roomgraph {

ById<NodeId, bool> confirmedNodes(const PoseGraph& graph, const NodePoses& poses,
                                  const ById<MatchGroupId, double>& belief) {
  ById<NodeId, bool> isConfirmed(graph.nodes.size());
  for (const MatchGroupId id : graph.groups.ids()) {
    const MatchGroup& group = graph.groups[id];
    if (group.from == group.to || belief[id] < beliefOf(kMajority)) continue;
    for (const PoseEdgeId match : group.edges) {
      const PoseEdge& edge = graph.edges[match];
      if (isInlier(edge, gapOf(edge, poses), kInlier))
        isConfirmed[edge.to] = isConfirmed[edge.from] = true;
    }
  }
  return isConfirmed;
}

std::vector<ScanStretch> gapsOf(const std::vector<bool>& isFound) {
  std::vector<ScanStretch> gaps;
  for (std::size_t k = 0; k < isFound.size(); ++k) {
    if (isFound[k]) continue;
    ScanStretch gap{k, k};
    while (gap.end < isFound.size() && !isFound[gap.end]) ++gap.end;
    gaps.push_back(gap);
    k = gap.end;
  }
  return gaps;
}

bool isLong(const ScanStretch& stretch, const std::vector<ScanWalls>& scans) {
  const std::vector<double> ways = drivenWays(scans);
  return stretch.size() >= fitted::kLongScans ||
         ways[stretch.end - 1] - ways[stretch.first] >= fitted::kLongWay;
}

}  // namespace roomgraph
