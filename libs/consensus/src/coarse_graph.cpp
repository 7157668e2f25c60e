#include "coarse_graph.h"

#include "roomgraph/align/near_poses.h"

namespace roomgraph {
namespace {

constexpr std::size_t kMostInNode = 4;  // key frames

/** Marks before which nodes of the finer graph a coarse one has to start: a group begins there, or
 *  has ended just before, or finds it otherwise than the node before. */
class NodeStarts {
 public:
  explicit NodeStarts(const PoseGraph& graph) : graph_(graph), isStart_(graph.nodes.size() + 1) {
    for (const MatchGroup& group : graph.groups) addGroup(group);
  }

  bool at(NodeId node) const { return isStart_[node.index()]; }

 private:
  void addGroup(const MatchGroup& group) {
    startAt(edgeAt(group, 0).to), startBehind(edgeAt(group, group.edges.size() - 1).to);
    for (std::size_t m = 1; m < group.edges.size(); ++m) {
      const PoseEdge &before = edgeAt(group, m - 1), &now = edgeAt(group, m);
      const Point place = graph_.nodes[now.to].pose.shift();
      if (areNear(placeBy(before), placeBy(now), place, kSameScanAnswer)) continue;
      startBehind(before.to), startAt(now.to);
      // Other groups are found both ways, each by itself.
      if (now.isSameScan) startBehind(before.from), startAt(now.from);
    }
  }

  const PoseEdge& edgeAt(const MatchGroup& group, std::size_t place) const {
    return graph_.edges[group.edges[place]];
  }

  /** Where a match has its run (run of `from` <- run of `to`). */
  Transform2D placeBy(const PoseEdge& match) const {
    return graph_.nodes[match.from].pose * match.measured * graph_.nodes[match.to].pose.inverse();
  }

  void startAt(NodeId node) { isStart_[node.index()] = true; }
  void startBehind(NodeId node) { isStart_[node.index() + 1] = true; }

  const PoseGraph& graph_;
  std::vector<bool> isStart_;
};

void addNodes(const GraphRun& run, const PoseGraph& graph, const NodeStarts& starts,
              CoarseGraph& coarse) {
  std::size_t count = 0;
  for (const NodeId id : run.nodes) {
    const PoseNode& node = graph.nodes[id];
    if (id == run.nodes.front() || !run.hasScans || starts.at(id) || count == kMostInNode)
      coarse.graph.addNode(node.pose, {}, node.axes), count = 0;
    coarse.coarseOf.add(coarse.graph.nodes.ids().back());
    ++count;
  }
}

}  // namespace

CoarseGraph coarseGraph(const PoseGraph& graph) {
  CoarseGraph coarse;
  const auto coarseOf = [&](NodeId node) { return coarse.coarseOf[node]; };
  const NodeStarts starts(graph);
  for (const GraphRun& run : graph.runs) {
    coarse.graph.addRun(run.hasScans);
    addNodes(run, graph, starts, coarse);
    for (const PoseEdgeId link : run.links) {
      const NodeId from = coarseOf(graph.edges[link].from), to = coarseOf(graph.edges[link].to);
      if (from != to) coarse.graph.addLink(from, to, graph.edges[link].share);
    }
  }
  // coarse node <- node, by the run's own poses
  const auto within = [&](NodeId node) {
    return coarse.graph.nodes[coarseOf(node)].pose.inverse() * graph.nodes[node].pose;
  };
  for (const MatchGroup& group : graph.groups) {
    std::vector<PoseEdge> matches;
    for (const PoseEdgeId id : group.edges) {
      PoseEdge edge = graph.edges[id];
      edge.measured = within(edge.from) * edge.measured * within(edge.to).inverse();
      edge.from = coarseOf(edge.from), edge.to = coarseOf(edge.to);
      matches.push_back(edge);
    }
    coarse.graph.addGroup(group, matches);
  }
  coarse.graph.reference = graph.reference;
  return coarse;
}

NodePoses coarsePoses(const CoarseGraph& coarse, const NodePoses& poses) {
  NodePoses result;
  for (const NodeId node : poses.ids())
    if (coarse.coarseOf[node].index() == result.size()) result.add(poses[node]);
  return result;
}

NodePoses finePoses(const CoarseGraph& coarse, const NodePoses& shape, const NodePoses& poses) {
  const NodePoses first = coarsePoses(coarse, shape);
  NodePoses result;
  for (const NodeId node : shape.ids()) {
    const NodeId there = coarse.coarseOf[node];
    result.add(poses[there] * first[there].inverse() * shape[node]);
  }
  return result;
}

}  // namespace roomgraph
