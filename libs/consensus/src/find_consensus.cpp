#include "roomgraph/consensus/find_consensus.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "fitted_consensus.h"
#include "move_stretches.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/consensus/belief.h"
#include "roomgraph/consensus/solve_pose_graph.h"
#include "start_poses.h"

namespace roomgraph {
namespace {

/** A graph of two runs: all that is known, which stays where it lies, and the one that is added. */
PoseGraph graphBeside(const PoseGraph& graph, RunId added, const std::vector<MatchGroupId>& groups,
                      const std::set<RunId>& others, const NodePoses& poses) {
  PoseGraph beside;
  ById<NodeId, NodeId> placeOf(graph.nodes.size());
  const auto add = [&](NodeId id, const Transform2D& pose) {
    placeOf[id] = beside.addNode(pose, graph.nodes[id].points, graph.nodes[id].axes);
  };
  const RunId known = beside.reference = beside.addRun(true);
  for (const RunId run : others)
    for (const NodeId id : graph.runs[run].nodes) add(id, poses[id]);
  const RunId own = beside.addRun(graph.runs[added].hasScans);
  for (const NodeId id : graph.runs[added].nodes) add(id, graph.nodes[id].pose);
  for (const PoseEdgeId id : graph.runs[added].links) {
    const PoseEdge& link = graph.edges[id];
    beside.addLink(placeOf[link.from], placeOf[link.to], link.share);
  }
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

constexpr std::size_t kFewRuns = 5;

/** The coarse form of a graph of many runs. With few runs each key frame tells. */
std::optional<CoarseGraph> coarseOfMany(const PoseGraph& graph) {
  if (graph.runs.size() <= kFewRuns) return std::nullopt;
  return coarseGraph(graph);
}

/** Solves a graph by its coarse form; nodes keep their `shape` within a coarse one. */
NodePoses solvedCoarsely(const PoseGraph& graph, const CoarseGraph& coarse, const GraphTrust& trust,
                         const NodePoses& shape, const NodePoses& start, StartIs startIs) {
  NodePoses poses =
      finePoses(coarse, shape,
                solvePoseGraph(coarse.graph, trust, coarsePoses(coarse, start), startIs).poses);
  if (graph.reference)  // to the last bit
    for (const NodeId node : graph.runs[graph.reference].nodes) poses[node] = start[node];
  return poses;
}

struct Solution {
  PoseGraphSolution found;
  GraphTrust trust;
};

Solution solvedFrom(const PoseGraph& graph, const std::optional<CoarseGraph>& coarse,
                    const NodePoses& start) {
  GraphTrust trust{ById<RunId, double>(graph.runs.size(), 1), beliefIn(graph, start, kRoughly)};
  NodePoses poses =
      coarse ? solvedCoarsely(graph, *coarse, trust, graph.ownPoses(), start, StartIs::rough)
             : solvePoseGraph(graph, trust, start, StartIs::rough).poses;
  moveStretches(graph, trust.slack, poses);
  trust.belief = beliefIn(graph, poses, kInlier);
  Solution solution{solvePoseGraph(graph, trust, poses, StartIs::good), trust};
  solution.found.cost += costOfDisbelief(graph, trust.belief);
  return solution;
}

/** Where the search begins: where no run is torn, and in the frame of each run, the pivots. Of many
 *  runs one is enough: most of them are not torn where it is. */
std::vector<NodePoses> startsOf(const PoseGraph& graph) {
  std::vector<NodePoses> starts{wholePoses(graph)};
  if (graph.reference) {
    starts.push_back(startPoses(graph, graph.reference));
    return starts;
  }
  const std::size_t pivots = graph.runs.size() > kFewRuns ? 1 : graph.runs.size();
  for (std::size_t pivot = 0; pivot < pivots; ++pivot)
    starts.push_back(startPoses(graph, RunId(pivot)));
  return starts;
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
  result.slack = found.trust.slack[own];
  result.error = mapError(beside, own, found.best, others.size());
  return result;
}

CoarseGraph coarseGraph(const PoseGraph& graph) {
  CoarseGraph coarse;
  const auto coarseOf = [&](NodeId node) { return coarse.coarseOf[node]; };
  const std::vector<bool> isStart = nodeStarts(graph);
  for (const GraphRun& run : graph.runs) {
    coarse.graph.addRun(run.hasScans);
    addNodes(run, graph, isStart, coarse);
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

ConsensusPoses findConsensus(const PoseGraph& graph, const ForEach& forEach) {
  if (graph.runs.size() == 0) return {};
  const std::vector<NodePoses> starts = startsOf(graph);
  const std::optional<CoarseGraph> coarse = coarseOfMany(graph);
  std::vector<Solution> solutions(starts.size());
  forEach(starts.size(),
          [&](std::size_t i) { solutions[i] = solvedFrom(graph, coarse, starts[i]); });
  const auto best = std::min_element(
      solutions.begin(), solutions.end(),
      [](const Solution& l, const Solution& r) { return l.found.cost < r.found.cost; });
  GraphTrust trust{runSlack(graph, best->found.poses), best->trust.belief};
  NodePoses start = best->found.poses;
  if (coarse) start = solvedCoarsely(graph, *coarse, trust, start, start, StartIs::good);
  ConsensusPoses result{
      solvePoseGraph(graph, trust, start, StartIs::good).poses, std::move(trust), {}};
  for (auto other = solutions.begin(); other != solutions.end(); ++other)
    if (other != best && other->found.cost <= fitted::kAboutAsGood * best->found.cost)
      result.others.push_back(std::move(other->found.poses));
  return result;
}

}  // namespace roomgraph
