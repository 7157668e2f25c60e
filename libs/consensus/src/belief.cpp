#include "roomgraph/consensus/belief.h"

#include <algorithm>
#include <cmath>

#include "fitted_consensus.h"

namespace roomgraph {

double beliefOf(double share) {
  constexpr double kLeast = 1e-3;  // so that a group can come back
  return std::max(kLeast, share * share);
}

double costOfGivingUp(const MatchGroup& group) {
  return fitted::kGivingUp * std::sqrt(double(group.edges.size())) *
         std::clamp((fitted::kAlikeTo - group.aliasing) / (fitted::kAlikeTo - fitted::kAlikeFrom),
                    fitted::kLeastCost, 1.0);
}

ById<MatchGroupId, double> beliefIn(const PoseGraph& graph, const NodePoses& poses,
                                    const PoseTolerance& within) {
  ById<MatchGroupId, double> belief;
  for (const MatchGroup& group : graph.groups) {
    double inliers = 0;
    for (const PoseEdgeId id : group.edges)
      inliers += isInlier(graph.edges[id], gapOf(graph.edges[id], poses), within);
    belief.add(beliefOf(inliers / double(group.edges.size())));
  }
  return belief;
}

double costOfDisbelief(const PoseGraph& graph, const ById<MatchGroupId, double>& belief) {
  double cost = 0;
  for (const MatchGroupId id : graph.groups.ids())
    cost += costOfGivingUp(graph.groups[id]) * (1 - belief[id]);
  return cost;
}

}  // namespace roomgraph
