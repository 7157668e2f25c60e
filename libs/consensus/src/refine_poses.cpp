#include "refine_poses.h"

#include "match_runs.h"
#include "roomgraph/consensus/find_consensus.h"
#include "roomgraph/consensus/solve_pose_graph.h"

namespace roomgraph {
namespace {

/** Each node where the best of its matches, of those from a group on, has it. */
NodePoses posesByMatches(const PoseGraph& graph, std::size_t firstGroup, const NodePoses& poses) {
  NodePoses found = poses;
  ById<NodeId, double> most(poses.size());
  for (std::size_t g = firstGroup; g < graph.groups.size(); ++g)
    for (const PoseEdgeId id : graph.groups[MatchGroupId(g)].edges) {
      const PoseEdge& match = graph.edges[id];
      if (graph.runOf(match.to) == graph.reference || match.share <= most[match.to]) continue;
      most[match.to] = match.share;
      found[match.to] = poses[match.from] * match.measured;
    }
  return found;
}

}  // namespace

void refinePoses(Consensus& consensus, const Site& site, const MapPairs& pairs,
                 const ForEach& forEach) {
  if (consensus.graph.runs.size() < 2 || consensus.graph.runs.size() > kFewRuns) return;
  PoseGraph graph = consensus.graph;
  GraphTrust trust = consensus.trust;
  for (const FoundGroup& found : matchRunsAgain(site, pairs, consensus, forEach)) {
    graph.addGroup(found.group, found.matches);
    trust.belief.add(1);
  }
  const NodePoses start = posesByMatches(graph, consensus.graph.groups.size(), consensus.poses);
  consensus.poses = solvePoseGraph(graph, trust, start, StartIs::good).poses;
}

}  // namespace roomgraph
