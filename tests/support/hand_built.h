#pragma once
#include <cmath>
#include <vector>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph::test {

constexpr auto kJunction = VertexKind::junction;
constexpr auto kDeadEnd = VertexKind::deadEnd;

/** A path along the points, with an obstacle 1 m to the left of the middle of each segment. */
inline Path straight(const Polyline& points) {
  std::vector<Point> obstacles;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point along = points[i + 1] - points[i];
    obstacles.push_back(midpoint(points[i], points[i + 1]) +
                        (1 / norm(along)) * Point{-along.y, along.x});
  }
  return makePath(points, obstacles);
}

/** A junction at the origin, vertex 0, with one dead end of each length; clearance 1 everywhere. */
inline TopologyGraph star(const std::vector<double>& lengths) {
  std::vector<Vertex> vertices{{{0, 0}, 1, VertexKind::junction, {}}};
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double angle = 2 * M_PI * double(i) / double(lengths.size());
    const Point tip = lengths[i] * Point{std::cos(angle), std::sin(angle)};
    vertices.push_back({tip, 1, VertexKind::deadEnd, {}});
    edges.push_back({VertexId(0), VertexId(i + 1), straight({{0, 0}, tip}), {}});
  }
  return {vertices, edges};
}

}  // namespace roomgraph::test
