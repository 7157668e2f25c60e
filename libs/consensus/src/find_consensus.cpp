#include "roomgraph/consensus/find_consensus.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "coarse_graph.h"
#include "edge_cost.h"
#include "fitted_consensus.h"
#include "move_stretches.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/consensus/belief.h"
#include "roomgraph/consensus/solve_pose_graph.h"
#include "roomgraph/relate/PairBend.h"
#include "start_poses.h"

namespace roomgraph {
namespace {

/** The coarse form of a graph of many runs. */
std::optional<CoarseGraph> coarseOfMany(const PoseGraph& graph) {
  if (graph.runs.size() <= kFewRuns) return std::nullopt;
  return coarseGraph(graph);
}

/** Solves a graph by its coarse form; nodes keep their `shape` within a coarse one. */
PoseGraphSolution solvedCoarsely(const PoseGraph& graph, const CoarseGraph& coarse,
                                 const GraphTrust& trust, const NodePoses& shape,
                                 const NodePoses& start, StartIs startIs) {
  PoseGraphSolution found =
      solvePoseGraph(coarse.graph, trust, coarsePoses(coarse, start), startIs);
  found.poses = finePoses(coarse, shape, found.poses);
  if (graph.reference)  // to the last bit
    for (const NodeId node : graph.runs[graph.reference].nodes) found.poses[node] = start[node];
  return found;
}

/** Which runs others show the place of. */
ById<RunId, bool> joinedRuns(const PoseGraph& graph, const ById<MatchGroupId, double>& belief) {
  ById<RunId, bool> isJoined(graph.runs.size());
  for (const MatchGroupId id : graph.groups.ids()) {
    const MatchGroup& group = graph.groups[id];
    if (group.from != group.to && belief[id] > kGivenUp)
      isJoined[group.from] = isJoined[group.to] = true;
  }
  return isJoined;
}

/** The graph with the links of those runs longer or shorter that need it to lie as the reference
 *  does, or the run in the middle of at least three. How large the whole site is does not show:
 *  noise makes it shrink. */
PoseGraph stretched(PoseGraph graph, const ById<MatchGroupId, double>& belief,
                    const ById<RunId, double>& found) {
  const ById<RunId, bool> isJoined = joinedRuns(graph, belief);
  const auto isTold = [&](RunId run) { return isJoined[run] && graph.showsStretch(run); };
  std::vector<double> told;
  for (const RunId run : graph.runs.ids())
    if (isTold(run)) told.push_back(found[run]);
  const bool areEnough = graph.reference || told.size() > kFewestOthers;
  const double middle = graph.reference || !areEnough ? 1 : median(told);
  for (const RunId run : graph.runs.ids()) {
    const double stretch = found[run] / middle;
    const bool isOwn = areEnough && isTold(run) && std::abs(stretch - 1) >= fitted::kUsualStretch;
    graph.setStretch(run, isOwn ? stretch : 1);
  }
  return graph;
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
  PoseGraphSolution rough =
      coarse ? solvedCoarsely(graph, *coarse, trust, graph.ownPoses(), start, StartIs::rough)
             : solvePoseGraph(graph, trust, start, StartIs::rough);
  const PoseGraph even = stretched(graph, trust.belief, rough.stretches);
  moveStretches(even, trust.slack, rough.poses);
  trust.belief = beliefIn(even, rough.poses, kInlier);
  Solution solution{solvePoseGraph(even, trust, rough.poses, StartIs::good), trust};
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
  std::optional<CoarseGraph> coarse = coarseOfMany(graph);
  std::vector<Solution> solutions(starts.size());
  forEach(starts.size(),
          [&](std::size_t i) { solutions[i] = solvedFrom(graph, coarse, starts[i]); });
  const auto best = std::min_element(
      solutions.begin(), solutions.end(),
      [](const Solution& l, const Solution& r) { return l.found.cost < r.found.cost; });
  PoseGraph even = graph;
  even.setStretches(best->found.stretches);
  GraphTrust trust{runSlack(even, best->found.poses), best->trust.belief};
  NodePoses start = best->found.poses;
  if (coarse) {
    coarse->graph.setStretches(best->found.stretches);
    start = solvedCoarsely(even, *coarse, trust, start, start, StartIs::good).poses;
  }
  PoseGraphSolution refined = solvePoseGraph(even, trust, start, StartIs::good);
  ConsensusPoses result{
      std::move(refined.poses), std::move(refined.stretches), std::move(trust), {}};
  for (auto other = solutions.begin(); other != solutions.end(); ++other)
    if (other != best && other->found.cost <= fitted::kAboutAsGood * best->found.cost)
      result.others.push_back(std::move(other->found.poses));
  return result;
}

}  // namespace roomgraph
