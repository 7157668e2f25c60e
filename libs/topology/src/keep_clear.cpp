#include "roomgraph/topology/keep_clear.h"

#include <algorithm>

namespace roomgraph {

void describe(KeepClearOptions& options, FieldTable& table) {
  table.number(
      "keep_clear", "min_clearance", options.minClearance, "m", 0, 10,
      "Voronoi edges that come nearer to an obstacle are dropped; never below 0.75 cells.");
}

double effectiveClearance(const KeepClearOptions& options, double resolution) {
  return std::max(options.minClearance, 0.75 * resolution) * (1 - kSameWidth);
}

EdgeIndices keepClear(const VoronoiGraph& graph, const InsideFlags& isInside, double clearance) {
  EdgeIndices kept;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const VoronoiEdge& edge = graph.edges[i];
    if (edge.isInfinite() || edge.minClearance < clearance) continue;
    if (isInside[edge.source] && isInside[edge.target]) kept.push_back(std::uint32_t(i));
  }
  return kept;
}

}  // namespace roomgraph
