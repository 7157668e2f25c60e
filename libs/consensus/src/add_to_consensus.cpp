#include "roomgraph/consensus/add_to_consensus.h"

#include <set>
#include <utility>

#include "roomgraph/consensus/find_consensus.h"

namespace roomgraph {
namespace {

/** A graph of two runs: all that is known, which stays where it lies, and the one that is added. */
class GraphBeside {
 public:
  GraphBeside(const PoseGraph& graph, RunId added, const std::vector<MatchGroupId>& groups,
              const NodePoses& poses)
      : all_(graph), placeOf_(graph.nodes.size()) {
    known_ = graph_.reference = graph_.addRun(true);
    for (const MatchGroupId group : groups)
      for (const RunId run : {graph.groups[group].from, graph.groups[group].to})
        if (run != added && others_.insert(run).second) addKnown(run, poses);
    added_ = graph_.addRun(graph.runs[added].hasScans);
    for (const NodeId id : graph.runs[added].nodes) {
      const PoseNode& node = graph.nodes[id];
      placeOf_[id] = graph_.addNode(node.pose, node.points, node.axes);
    }
    for (const PoseEdgeId id : graph.runs[added].links) {
      const PoseEdge& link = graph.edges[id];
      graph_.addLink(placeOf_[link.from], placeOf_[link.to], link.share);
    }
    for (const MatchGroupId group : groups) addGroup(graph.groups[group]);
  }

  const PoseGraph& graph() const { return graph_; }
  RunId added() const { return added_; }
  std::size_t others() const { return others_.size(); }

 private:
  void addKnown(RunId run, const NodePoses& poses) {
    for (const NodeId id : all_.runs[run].nodes)
      placeOf_[id] = graph_.addNode(poses[id], all_.nodes[id].points, all_.nodes[id].axes);
  }

  RunId placeOf(RunId run) const { return others_.count(run) > 0 ? known_ : added_; }

  void addGroup(const MatchGroup& group) {
    std::vector<PoseEdge> matches;
    for (const PoseEdgeId id : group.edges) {
      matches.push_back(all_.edges[id]);
      PoseEdge& match = matches.back();
      match.from = placeOf_[match.from], match.to = placeOf_[match.to];
    }
    graph_.addGroup({placeOf(group.from), placeOf(group.to), {}, group.aliasing}, matches);
  }

  const PoseGraph& all_;
  PoseGraph graph_;
  RunId known_, added_;
  std::set<RunId> others_;  // those that are known
  ById<NodeId, NodeId> placeOf_;
};

}  // namespace

AddedToConsensus addToConsensus(const PoseGraph& graph, RunId added,
                                const std::vector<MatchGroupId>& groups, const NodePoses& poses) {
  const GraphBeside beside(graph, added, groups, poses);
  const ConsensusPoses found = findConsensus(beside.graph());
  AddedToConsensus result;
  for (const NodeId node : beside.graph().runs[beside.added()].nodes)
    result.poses.push_back(found.best[node]);
  result.slack = found.trust.slack[beside.added()];
  result.error = mapError(beside.graph(), beside.added(), found.best, beside.others());
  return result;
}

}  // namespace roomgraph
