#include "roomgraph/topology/dead_ends.h"

#include <algorithm>

namespace roomgraph {
namespace {

/** Removes each dead end that `isShort`, all at once; returns whether there was one. An edge with
 *  two dead ends is a whole component and stays. */
bool removeLayer(TopologyGraph& graph, const DeadEndTest& isShort) {
  std::vector<bool> keepVertex(graph.vertices().size(), true);
  std::vector<bool> keepEdge(graph.edges().size(), true);
  bool isAny = false;
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const Edge& edge = graph.edges()[e];
    const bool sourceIsTip = graph.degree(edge.source) == 1;
    if (sourceIsTip == (graph.degree(edge.target) == 1)) continue;
    const VertexId tip = sourceIsTip ? edge.source : edge.target;
    const VertexId base = sourceIsTip ? edge.target : edge.source;
    if (!isShort(graph.vertex(tip), graph.vertex(base), edge.path)) continue;
    keepEdge[e] = false;
    keepVertex[tip.index()] = false;
    isAny = true;
  }
  if (isAny) graph = dissolveThrough(keepOnly(std::move(graph), keepVertex, keepEdge));
  return isAny;
}

/** Whether what lies so far along a path [m] is hardly beyond the disc of a clearance. */
bool isWithin(double clearance, double farthest, const DeadEndsOptions& options) {
  return farthest - clearance < std::max(options.minReach, options.minReachRatio * clearance);
}

}  // namespace

void describe(DeadEndsOptions& options, FieldTable& table) {
  const char* section = "dead_ends";
  table.number(section, "min_reach_ratio", options.minReachRatio, "", 0, 10,
               "A dead end is kept if it reaches beyond the free disc around its junction by at "
               "least this share of the disc's radius.");
  table.number(section, "min_reach", options.minReach, "m", 0, 100,
               "The least reach of a dead end beyond that disc.");
  table.flag(section, "all_once", options.allOnce,
             "First remove every dead end once, whatever its length, as the paper does.");
  table.number(section, "min_length_px", options.minLengthPx, "px", 0, 1e6,
               "Then remove, once, all dead ends shorter than this; 0 for the reach rule.");
}

TopologyGraph removeDeadEndsWhere(TopologyGraph graph, const DeadEndTest& isShort) {
  while (removeLayer(graph, isShort)) {
  }
  return graph;
}

TopologyGraph removeDeadEnds(TopologyGraph graph, const DeadEndsOptions& options, double resolution,
                             const LeadsOn& leadsOn) {
  if (options.allOnce)
    removeLayer(graph, [](const Vertex&, const Vertex&, const Path&) { return true; });
  if (options.minLengthPx > 0) {
    removeLayer(graph, [&](const Vertex&, const Vertex&, const Path& path) {
      return path.length < options.minLengthPx * resolution;
    });
    return graph;
  }
  return removeDeadEndsWhere(std::move(graph), [&](const Vertex& tip, const Vertex& base,
                                                   const Path& path) {
    return isWithin(base.clearance, path.length + tip.clearance, options) && !leadsOn(tip, base);
  });
}

TopologyGraph removeEndsAmongClutter(TopologyGraph graph, const DeadEndsOptions& options,
                                     const ObstacleRows& walls, const LeadsOn& leadsOn) {
  return removeDeadEndsWhere(
      std::move(graph), [&](const Vertex& tip, const Vertex& base, const Path& path) {
        const double farthest = path.length + tip.clearance;
        if (!isWithin(base.clearance, farthest, options)) {
          // From here on it is within, whatever it is: no need to look farther, but for rounding.
          const double enough =
              std::min(farthest - options.minReach, farthest / (1 + options.minReachRatio));
          const double clearance = walls.clearance(base.place, base.place, enough * (1 + 1e-9));
          if (!isWithin(clearance, farthest, options)) return false;
        }
        return !leadsOn(tip, base);
      });
}

}  // namespace roomgraph
