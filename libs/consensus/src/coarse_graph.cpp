#include "coarse_graph.h"

#include "roomgraph/align/near_poses.h"

namespace roomgraph {
namespace {

constexpr std::size_t kMostInNode = 4;  // key frames

/** Of each node of the finer graph whether a coarse one has to start with it: a group begins there,
 *  or has ended just before, or finds it otherwise than the node before. */
std::vector<bool> nodeStarts(const PoseGraph& graph) {
  std::vector<bool> isStart(graph.nodes.size() + 1);
  const auto startAt = [&](NodeId node) { isStart[node.index()] = true; };
  const auto startBehind = [&](NodeId node) { isStart[node.index() + 1] = true; };
  // Where a match has its run (run of `from` <- run of `to`).
  const auto placeBy = [&](const PoseEdge& match) {
    return graph.nodes[match.from].pose * match.measured * graph.nodes[match.to].pose.inverse();
  };
  for (const MatchGroup& group : graph.groups) {
    startAt(graph.edges[group.edges.front()].to), startBehind(graph.edges[group.edges.back()].to);
    for (std::size_t m = 1; m < group.edges.size(); ++m) {
      const PoseEdge &before = graph.edges[group.edges[m - 1]], &now = graph.edges[group.edges[m]];
      const Point place = graph.nodes[now.to].pose.shift();
      if (areNear(placeBy(before), placeBy(now), place, kSameScanAnswer)) continue;
      startBehind(before.to), startAt(now.to);
      // Other groups are found both ways, each by itself.
      if (now.isSameScan) startBehind(before.from), startAt(now.from);
    }
  }
  return isStart;
}

void addNodes(const GraphRun& run, const PoseGraph& graph, const std::vector<bool>& isStart,
              CoarseGraph& coarse) {
  std::size_t count = 0;
  for (const NodeId id : run.nodes) {
    const PoseNode& node = graph.nodes[id];
    if (id == run.nodes.front() || !run.hasScans || isStart[id.index()] || count == kMostInNode)
      coarse.graph.addNode(node.pose, {}, node.axes), count = 0;
    coarse.coarseOf.add(coarse.graph.nodes.ids().back());
    ++count;
  }
}

}  // namespace

CoarseGraph coarseGraph(const PoseGraph& graph) {
  CoarseGraph coarse;
  const auto coarseOf = [&](NodeId node) { return coarse.coarseOf[node]; };
  const std::vector<bool> isStart = nodeStarts(graph);
  for (const GraphRun& run : graph.runs) {
    const RunId id = coarse.graph.addRun(run.hasScans);
    addNodes(run, graph, isStart, coarse);
    for (const PoseEdgeId link : run.links) {
      const NodeId from = coarseOf(graph.edges[link].from), to = coarseOf(graph.edges[link].to);
      if (from != to) coarse.graph.addLink(from, to, graph.edges[link].share);
    }
    coarse.graph.setStretch(id, run.stretch);
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
