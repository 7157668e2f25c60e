#include "roomgraph/consensus/find_consensus.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "coarse_graph.h"
#include "edge_cost.h"
#include "fitted_consensus.h"
#include "move_stretches.h"
#include "roomgraph/consensus/belief.h"
#include "roomgraph/consensus/solve_pose_graph.h"
#include "start_poses.h"

namespace roomgraph {
namespace {

/** The coarse form of a graph of many runs. */
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

double costOfLeaps(const PoseGraph& graph, const NodePoses& poses) {
  double cost = 0;
  for (const PoseEdge& edge : graph.edges)
    cost += costOfLeap(edge, distance(poses[edge.from].shift(), poses[edge.to].shift()));
  return cost;
}

Solution solvedFrom(const PoseGraph& graph, const std::optional<CoarseGraph>& coarse,
                    const NodePoses& start) {
  GraphTrust trust{ById<RunId, double>(graph.runs.size(), 1), beliefIn(graph, start, kRoughly)};
  NodePoses poses =
      coarse ? solvedCoarsely(graph, *coarse, trust, graph.ownPoses(), start, StartIs::rough)
             : solvePoseGraph(graph, trust, start, StartIs::rough).poses;
  moveStretches(graph, trust.slack, poses);
  trust.belief = beliefIn(graph, poses, kInlier);
  Solution solution{solvePoseGraph(graph, trust, poses, StartIs::good), trust};
  solution.found.cost +=
      costOfDisbelief(graph, trust.belief) + costOfLeaps(graph, solution.found.poses);
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
