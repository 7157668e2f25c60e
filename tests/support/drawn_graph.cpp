#include "drawn_graph.h"

#include <utility>

namespace roomgraph::test {

TopologyGraph mapped(const TopologyGraph& graph, const std::function<Point(Point)>& place) {
  std::vector<Vertex> vertices = graph.vertices();
  for (Vertex& v : vertices) v.place = place(v.place);
  std::vector<Edge> edges;
  for (Edge edge : graph.edges()) {
    for (Point& p : edge.path.points) p = place(p);
    edge.path = makePath(std::move(edge.path.points), {});
    edges.push_back(std::move(edge));
  }
  return {std::move(vertices), std::move(edges)};
}

TopologyGraph drawnGraph() {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  const auto add = [&](Point at, VertexKind kind) {
    vertices.push_back({at, 0.8 + 0.05 * at.x, kind, RoomId::none()});
    return VertexId(vertices.size() - 1);
  };
  const auto join = [&](VertexId a, VertexId b) {
    const Point from = vertices[a.index()].place, to = vertices[b.index()].place;
    Polyline line;
    for (int k = 0; k <= 10; ++k) line.push_back(from + (k / 10.0) * (to - from));
    edges.push_back({a, b, makePath(line, {}), RoomId::none()});
  };
  const VertexId west = add({0, 0}, VertexKind::deadEnd);
  VertexId last = add({3.5, 0}, VertexKind::junction);
  join(west, last);
  const VertexId middle = add({5.5, 0}, VertexKind::border);
  join(last, middle);
  join(last, add({3.5, 2.5}, VertexKind::deadEnd));
  last = middle;
  int side = -1;
  for (const double x : {8.0, 12.5, 16.0, 20.0}) {
    const VertexId next = add({x, 0}, VertexKind::junction);
    join(last, next);
    join(next, add({x, side * (1.5 + x / 8)}, VertexKind::deadEnd));
    if (x > 15) join(next, add({x, -side * x / 6}, VertexKind::deadEnd));
    last = next, side = -side;
  }
  return {vertices, edges};
}

TopologyGraph moved(const TopologyGraph& graph, const Transform2D& pose) {
  return mapped(graph, pose);
}

TopologyGraph bentAt(const TopologyGraph& graph, double x, const Transform2D& far) {
  return mapped(graph, [&](Point p) { return p.x > x ? far(p) : p; });
}

TopologyGraph westOf(const TopologyGraph& graph, double x) {
  std::vector<bool> vertices, edges;
  for (const Vertex& v : graph.vertices()) vertices.push_back(v.place.x < x);
  for (const Edge& e : graph.edges())
    edges.push_back(vertices[e.source.index()] && vertices[e.target.index()]);
  return keepOnly(graph, vertices, edges);
}

TopologyGraph withoutVertex(const TopologyGraph& graph, VertexId gone) {
  std::vector<Vertex> vertices = graph.vertices();
  const VertexId last(vertices.size() - 1);
  vertices[gone.index()] = vertices.back();
  vertices.pop_back();
  const auto renamed = [&](VertexId v) { return v == last ? gone : v; };
  std::vector<Edge> edges;
  for (const Edge& edge : graph.edges())
    if (edge.source != gone && edge.target != gone)
      edges.push_back({renamed(edge.source), renamed(edge.target), edge.path, edge.room});
  const auto out = graph.outgoing(gone);
  const HalfEdgeId first = *out.begin(), second = *(out.begin() + 1);
  edges.push_back({renamed(graph.target(first)), renamed(graph.target(second)),
                   joined(reversed(graph.halfPath(first)), graph.halfPath(second)),
                   RoomId::none()});
  return {std::move(vertices), std::move(edges)};
}

WallPatches patchesOver(const Transform2D& pose) {
  WallPatches patches;
  for (double x = -1; x < 22; x += 2)
    for (double y = -5; y < 6; y += 2) {
      WallPatch patch;
      patch.middle = pose({x, y});
      patches.push_back(patch);
    }
  return patches;
}

FollowedWalls everywhere(const WallPatches& patches, const Transform2D& pose) {
  FollowedWalls followed;
  for (std::uint32_t i = 0; i < patches.size(); ++i) followed.patches.push_back({i, pose, 10, 0});
  followed.pose = pose;
  followed.share = 1;
  return followed;
}

}  // namespace roomgraph::test
