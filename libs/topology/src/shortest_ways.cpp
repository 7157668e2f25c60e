#include "roomgraph/topology/shortest_ways.h"

namespace roomgraph {

ShortestWays::ShortestWays(const TopologyGraph& graph, const std::vector<EdgeId>& edges,
                           PlaceOnPath start, double minClearance)
    : graph_(graph) {
  for (const EdgeId e : edges) {
    if (graph.edge(e).path.minClearance < minClearance) continue;
    for (const HalfEdgeId h : {HalfEdgeId(2 * e.index()), HalfEdgeId(2 * e.index() + 1)})
      ways_[graph.source(h)].push_back(h);
  }
  const Edge& edge = graph.edge(start.edge);
  const auto begin = [&](VertexId v, Path path) {
    if (path.minClearance < minClearance) return;
    const double length = path.length;
    offer(v, length, HalfEdgeId::none(), std::move(path));
  };
  begin(edge.target, piece(edge.path, start.along, edge.path.length));
  begin(edge.source, reversed(piece(edge.path, 0, start.along)));
  run();
}

Path ShortestWays::pathTo(VertexId v) const {
  const Way& way = best_.at(v);
  if (!way.last) return way.first;
  return joined(pathTo(graph_.source(way.last)), graph_.halfPath(way.last));
}

void ShortestWays::offer(VertexId v, double length, HalfEdgeId last, Path first) {
  const auto it = best_.find(v);
  if (it != best_.end() && it->second.length <= length) return;
  best_[v] = {length, last, std::move(first)};
  open_.push({length, v});
}

void ShortestWays::run() {
  while (!open_.empty()) {
    const auto [length, at] = open_.top();
    open_.pop();
    if (length > best_.at(at).length) continue;
    for (const HalfEdgeId h : ways_[at])
      offer(graph_.target(h), length + graph_.edge(h).path.length, h, {});
  }
}

}  // namespace roomgraph
