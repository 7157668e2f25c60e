#include "roomgraph/rooms/inner_ways.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "join_leftovers.h"
#include "place_on_paths.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/topology/dead_ends.h"

namespace roomgraph {
namespace {

/** A dead end is no place where it reaches less than this [widths of the robot]. */
constexpr double kLeastReach = 4;

/** A graph of these edges alone: first its border vertices, then the others, in their order. */
TopologyGraph partOf(const TopologyGraph& graph, const std::vector<EdgeId>& edges) {
  const auto rank = [&](VertexId v) {
    return std::pair(graph.vertex(v).kind != VertexKind::border, v);
  };
  std::map<std::pair<bool, VertexId>, VertexId> newId;
  for (const EdgeId e : edges)
    for (const VertexId v : {graph.edge(e).source, graph.edge(e).target}) newId[rank(v)];
  std::vector<Vertex> vertices;
  for (auto& [old, id] : newId) {
    id = VertexId(vertices.size());
    vertices.push_back(graph.vertex(old.second));
  }
  std::vector<Edge> part;
  for (const EdgeId e : edges) {
    part.push_back(graph.edge(e));
    part.back().source = newId.at(rank(part.back().source));
    part.back().target = newId.at(rank(part.back().target));
  }
  return {std::move(vertices), std::move(part)};
}

/** Without what is too narrow, but still in one piece: the widest ways hold it together. */
TopologyGraph wideWays(TopologyGraph graph, double minClearance) {
  const std::size_t count = graph.edges().size();
  std::vector<std::size_t> order = numbersFrom(0, count);
  const auto clearance = [&](std::size_t e) { return graph.edges()[e].path.minClearance; };
  sortBy(order, [&](std::size_t e) {  // of those as wide the shorter first
    return std::pair(-float(clearance(e)), float(graph.edges()[e].path.length));
  });
  UnionFind groups(graph.vertices().size());
  std::vector<bool> keepEdge(count);
  for (const std::size_t e : order) {
    const Edge& edge = graph.edges()[e];
    const bool isLink = groups.join(edge.source.index(), edge.target.index());
    keepEdge[e] = isLink || clearance(e) >= minClearance;
  }
  const std::vector<bool> keepVertex(graph.vertices().size(), true);
  return dissolveThrough(keepOnly(std::move(graph), keepVertex, keepEdge));
}

/** Whether more than one path, or than a tree with a border vertex at each tip, is left. */
bool tellsMore(const TopologyGraph& graph) {
  if (graph.edges().empty()) return false;
  if (graph.edges().size() >= graph.vertices().size()) return true;
  if (graph.edges().size() == 1) return false;
  for (std::size_t v = 0; v < graph.vertices().size(); ++v)
    if (graph.vertices()[v].kind == VertexKind::deadEnd) return true;
  return false;
}

}  // namespace

TopologyGraph innerWays(const TopologyGraph& graph, const std::vector<EdgeId>& edges,
                        double robotWidth, double halfCell) {
  const double minClearance = (robotWidth / 2 + halfCell) * (1 - kSameWidth);
  TopologyGraph ways = wideWays(partOf(graph, edges), minClearance);
  ways = removeDeadEndsWhere(
      std::move(ways), [&](const Vertex& tip, const Vertex& base, const Path& path) {
        if (tip.kind == VertexKind::border) return false;
        if (path.minClearance < minClearance) return true;
        const double reach = path.length + tip.clearance - base.clearance;
        const double width = 2 * (tip.clearance - halfCell);
        return reach < std::max(kDeepestAlcove * width, kLeastReach * robotWidth);
      });
  return tellsMore(ways) ? ways : TopologyGraph();
}

TopologyGraph withRoomVertex(TopologyGraph ways, Point center, double minClearance) {
  std::vector<EdgeId> edges;
  for (std::size_t e = 0; e < ways.edges().size(); ++e) edges.push_back(EdgeId(e));
  const PlaceOnPath place = placeOnPaths(ways, edges, center, minClearance);
  std::vector<Vertex> vertices = ways.vertices();
  std::vector<Edge> parts = std::move(ways).takeEdges();
  const VertexId middle = splitAt(vertices, parts, place, VertexKind::room);
  vertices[middle.index()].kind = VertexKind::room;
  return {std::move(vertices), std::move(parts)};
}

TopologyGraph innerTree(const TopologyGraph& graph, const std::vector<EdgeId>& edges, Point center,
                        double minClearance) {
  TopologyGraph ways = withRoomVertex(partOf(graph, edges), center, minClearance);
  return removeDeadEndsWhere(
      wideWays(std::move(ways), HUGE_VAL), [](const Vertex& tip, const Vertex&, const Path&) {
        return tip.kind != VertexKind::border && tip.kind != VertexKind::room;
      });
}

}  // namespace roomgraph
