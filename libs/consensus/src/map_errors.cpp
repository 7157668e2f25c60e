#include "roomgraph/consensus/map_errors.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "fitted_consensus.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/MotionFit.h"

namespace roomgraph {
namespace {

/** Root mean square distance of points at two poses [m]. */
double restAt(const PointSums& points, const Transform2D& l, const Transform2D& r) {
  if (points.count <= 0) return distance(l.shift(), r.shift());
  const Transform2D apart = l.inverse() * r;
  const double c = 1 - std::cos(apart.phi), s = std::sin(apart.phi);
  const double n = points.count;
  const double x = (-c * points.x - s * points.y) / n, y = (s * points.x - c * points.y) / n;
  const double turned = 2 * c * (points.xx + points.yy) / n;  // |R p - p|^2 = 2 (1 - cos) |p|^2
  return std::sqrt(
      std::max(0.0, turned + 2 * (x * apart.x + y * apart.y) + squaredNorm(apart.shift())));
}

/** Of each node, the other runs that it was found in, or that have a node found in it. */
ById<NodeId, std::set<RunId>> seenBy(const PoseGraph& graph) {
  ById<NodeId, std::set<RunId>> runs(graph.nodes.size());
  for (const MatchGroup& group : graph.groups) {
    if (group.from == group.to) continue;
    for (const PoseEdgeId id : group.edges) {
      runs[graph.edges[id].from].insert(group.to);
      runs[graph.edges[id].to].insert(group.from);
    }
  }
  return runs;
}

/** How many runs the others are worth as witnesses of one: each that has seen half of what it has
 *  drawn one, others as much less as they have seen less. */
double witnessesOf(const PoseGraph& graph, RunId run, const ById<NodeId, std::set<RunId>>& seen) {
  ById<RunId, double> counts(graph.runs.size());
  double all = 0;
  for (const NodeId node : graph.runs[run].nodes) {
    all += graph.nodes[node].points.count;
    for (const RunId other : seen[node]) counts[other] += graph.nodes[node].points.count;
  }
  double witnesses = 0;
  for (const double count : counts)
    if (all > 0) witnesses += std::min(1.0, count / (kMajority * all));
  return witnesses;
}

/** e / f - p to e * f + p, see docs/method.md, "Map errors". */
void addInterval(MapError& error, double witnesses) {
  const double others = std::max(1.0, witnesses);
  // Round numbers, so that 75 to 90 % of the true errors lie in it on the sites of
  // benchmarks/README.md, with ten, five and three runs.
  const double factor =
      kEightyPercent * (fitted::kFactor + fitted::kFactorPerRun / others / others +
                        fitted::kFactorUnseen * (1 - error.seen));
  // All runs may share a scale that is off by as much as robots usually differ.
  const double place = fitted::kUsualStretch / 2 * error.reach + fitted::kMetresPerRun / others;
  error.low = std::max(0.0, error.error / std::exp(factor) - place);
  error.high = error.error * std::exp(factor) + place;
}

MapError errorOf(const PoseGraph& graph, RunId run, const NodePoses& poses,
                 const ById<NodeId, std::set<RunId>>& seenByOthers, double others) {
  const IdRange<NodeId>& nodes = graph.runs[run].nodes;
  MotionFit all;
  MapError error;
  double seen = 0;
  for (const NodeId id : nodes) {
    const PoseNode& node = graph.nodes[id];
    const bool isSeen = !seenByOthers[id].empty();
    all.add(node.points, node.pose, poses[id]);
    seen += isSeen ? node.points.count : 0;
    error.isSeen.push_back(isSeen);
  }
  error.error = all.rest(), error.pose = all.motion(), error.reach = all.reach();
  error.seen = all.weight() > 0 ? seen / all.weight() : 0;
  for (const NodeId id : nodes) {
    const PoseNode& node = graph.nodes[id];
    error.errors.push_back(restAt(node.points, poses[id], error.pose * node.pose));
  }
  addInterval(error, others);
  return error;
}

}  // namespace

ById<RunId, MapError> mapErrors(const PoseGraph& graph, const NodePoses& poses) {
  const ById<NodeId, std::set<RunId>> seen = seenBy(graph);
  ById<RunId, MapError> errors;
  for (const RunId run : graph.runs.ids())
    errors.add(errorOf(graph, run, poses, seen, witnessesOf(graph, run, seen)));
  return errors;
}

MapError mapError(const PoseGraph& graph, RunId run, const NodePoses& poses, std::size_t others) {
  return errorOf(graph, run, poses, seenBy(graph), double(others));
}

}  // namespace roomgraph
