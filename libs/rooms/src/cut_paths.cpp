#include "roomgraph/rooms/cut_paths.h"

#include <algorithm>

namespace roomgraph {
namespace {

Vertex borderVertex(const Path& before, const Stretch& a, const Stretch& b) {
  const Point place = before.points.back();
  return {place, distance(place, before.obstacles.back()), VertexKind::border,
          std::min(a.room, b.room)};  // none sorts last
}

}  // namespace

TopologyGraph cutPaths(TopologyGraph graph, const PathStretches& stretches) {
  std::vector<Vertex> vertices = graph.vertices();
  std::vector<Edge> whole = std::move(graph).takeEdges();
  std::vector<Edge> edges;
  for (std::size_t e = 0; e < whole.size(); ++e) {
    Edge& edge = whole[e];
    const auto& parts = stretches[e];
    edge.room = parts.front().room;
    if (parts.size() == 1) {
      edges.push_back(std::move(edge));
      continue;
    }
    VertexId source = edge.source;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Path path = piece(edge.path, parts[i].from, parts[i].to);
      VertexId target = edge.target;
      if (i + 1 < parts.size()) {
        target = VertexId(vertices.size());
        vertices.push_back(borderVertex(path, parts[i], parts[i + 1]));
      }
      edges.push_back({source, target, std::move(path), parts[i].room});
      source = target;
    }
  }
  return {std::move(vertices), std::move(edges)};
}

}  // namespace roomgraph
