#include "wall_axes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fitted_consensus.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

/** Successive nodes of a run whose walls lie along the same axes, as the run has drawn them. */
struct AlignedStretch {
  std::vector<NodeId> nodes;
  bool isWholeRun = false;
};

/** The axes of some nodes, and how far these are from them, half of the nodes less [rad]. */
struct CommonAxes {
  double direction = 0, scatter = 0;
};

CommonAxes commonAxes(const PoseGraph& graph, const NodePoses& poses,
                      const std::vector<NodeId>& nodes) {
  const auto axesOf = [&](NodeId node) { return poses[node].phi + graph.nodes[node].axes->turn; };
  std::vector<double> turns, gaps;
  for (const NodeId node : nodes) turns.push_back(axesAngle(axesOf(node) - axesOf(nodes.front())));
  const double middle = median(turns);
  for (const double turn : turns) gaps.push_back(std::abs(turn - middle));
  return {axesOf(nodes.front()) + middle, median(std::move(gaps))};
}

/** Whether the walls before a node and behind it lie along other axes, though the scans do not
 *  contradict the steps between. */
bool doAxesTurn(const PoseGraph& graph, const NodePoses& drawn, const std::vector<NodeId>& nodes,
                std::size_t at) {
  if (at <= fitted::kAcrossTurn || at + fitted::kAcrossTurn >= nodes.size()) return false;
  const std::size_t end = at - fitted::kAcrossTurn, behind = at + fitted::kAcrossTurn;
  const std::size_t first = end - std::min(end, fitted::kBesideTurn);
  const std::size_t last = std::min(nodes.size(), behind + fitted::kBesideTurn);
  for (std::size_t k = first + 1; k < last; ++k)
    if (graph.nodes[nodes[k]].isDoubtful) return false;
  const auto axesOf = [&](std::size_t from, std::size_t to) {
    return commonAxes(graph, drawn,
                      {nodes.begin() + std::ptrdiff_t(from), nodes.begin() + std::ptrdiff_t(to)});
  };
  const CommonAxes before = axesOf(first, end);
  const CommonAxes after = axesOf(behind, last);
  return std::abs(axesAngle(after.direction - before.direction)) > fitted::kAxesJump &&
         std::max(before.scatter, after.scatter) < fitted::kAxesTurn;
}

void addStretches(const PoseGraph& graph, const NodePoses& drawn, const GraphRun& run,
                  std::vector<AlignedStretch>& stretches) {
  std::vector<NodeId> nodes;
  for (const NodeId node : run.nodes)
    if (graph.nodes[node].axes) nodes.push_back(node);
  bool isNew = true;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool isTurn = doAxesTurn(graph, drawn, nodes, i);
    if (isNew && !isTurn) stretches.emplace_back();
    if (!isTurn) stretches.back().nodes.push_back(nodes[i]);
    isNew = isTurn;
  }
  if (!nodes.empty())  // of which the first are in no turn, so that a stretch was added
    stretches.back().isWholeRun = stretches.back().nodes.size() == nodes.size();
}

}  // namespace

double axesAngle(double angle) { return wrappedAngle(4 * angle) / 4; }

WallAxes wallAxes(const PoseGraph& graph, const NodePoses& start) {
  WallAxes axes{1, ById<NodeId, std::optional<std::size_t>>(graph.nodes.size())};
  std::vector<AlignedStretch> stretches;
  const NodePoses drawn = graph.ownPoses();
  for (const GraphRun& run : graph.runs) addStretches(graph, drawn, run, stretches);
  if (stretches.empty()) return axes;
  const auto directionOf = [&](const AlignedStretch& stretch) {
    return commonAxes(graph, start, stretch.nodes).direction;
  };
  const double most = directionOf(*std::max_element(
      stretches.begin(), stretches.end(), [](const AlignedStretch& l, const AlignedStretch& r) {
        return l.nodes.size() < r.nodes.size();
      }));
  for (const AlignedStretch& stretch : stretches) {
    const bool isOfMost =
        stretch.isWholeRun || std::abs(axesAngle(directionOf(stretch) - most)) <= fitted::kAxesJump;
    const std::size_t own = isOfMost ? 0 : axes.count++;
    for (const NodeId node : stretch.nodes) axes.ofNode[node] = own;
  }
  return axes;
}

}  // namespace roomgraph
