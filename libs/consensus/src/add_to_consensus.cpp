#include "roomgraph/consensus/add_to_consensus.h"

#include <set>

#include "roomgraph/consensus/find_consensus.h"

namespace roomgraph {
namespace {

/** A graph of two runs: all that is known, which stays where it lies, and the one that is added. */
PoseGraph graphBeside(const PoseGraph& graph, RunId added, const std::vector<MatchGroupId>& groups,
                      const std::set<RunId>& others, const NodePoses& poses) {
  PoseGraph beside;
  ById<NodeId, NodeId> placeOf(graph.nodes.size());
  const RunId known = beside.reference = beside.addRun(true);
  for (const RunId run : others)
    for (const NodeId id : graph.runs[run].nodes)
      placeOf[id] = beside.addNode(poses[id], graph.nodes[id].points, graph.nodes[id].axes);
  const RunId own = beside.addRun(graph, added);
  for (const NodeId id : beside.runs[own].nodes)
    placeOf[graph.runs[added].nodes[beside.runs[own].nodes.placeOf(id)]] = id;
  for (const MatchGroupId id : groups) {
    MatchGroup group = graph.groups[id];
    std::vector<PoseEdge> matches;
    for (const PoseEdgeId edge : group.edges) {
      PoseEdge match = graph.edges[edge];
      match.from = placeOf[match.from], match.to = placeOf[match.to];
      matches.push_back(match);
    }
    for (RunId* run : {&group.from, &group.to}) *run = *run == added ? own : known;
    beside.addGroup(group, matches);
  }
  return beside;
}

}  // namespace

AddedToConsensus addToConsensus(const PoseGraph& graph, RunId added,
                                const std::vector<MatchGroupId>& groups, const NodePoses& poses) {
  std::set<RunId> others;
  for (const MatchGroupId id : groups)
    for (const RunId run : {graph.groups[id].from, graph.groups[id].to})
      if (run != added) others.insert(run);
  const PoseGraph beside = graphBeside(graph, added, groups, others, poses);
  const ConsensusPoses found = findConsensus(beside);
  AddedToConsensus result;
  const RunId own(1);
  for (const NodeId node : beside.runs[own].nodes) result.poses.push_back(found.best[node]);
  result.stretch = found.stretches[own];
  result.slack = found.trust.slack[own];
  result.error = mapError(beside, own, found.best, others.size());
  return result;
}

}  // namespace roomgraph
