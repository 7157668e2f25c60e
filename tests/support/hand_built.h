#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph::test {

constexpr auto kJunction = VertexKind::junction;
constexpr auto kDeadEnd = VertexKind::deadEnd;

/** A path along the points, with an obstacle on the left of the middle of each segment. */
inline Path straight(const Polyline& points, double clearance = 1) {
  std::vector<Point> obstacles;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point along = points[i + 1] - points[i];
    obstacles.push_back(midpoint(points[i], points[i + 1]) +
                        (clearance / norm(along)) * Point{-along.y, along.x});
  }
  return makePath(points, obstacles);
}

/** The two vertices of each edge, by their numbers. */
using Ends = std::vector<std::pair<std::size_t, std::size_t>>;

/** Straight edges between vertices. */
inline TopologyGraph joinedUp(const std::vector<Vertex>& vertices, const Ends& ends) {
  std::vector<Edge> edges;
  for (const auto& [a, b] : ends)
    edges.push_back(
        {VertexId(a), VertexId(b), straight({vertices[a].place, vertices[b].place}), {}});
  return {vertices, edges};
}

/** The same between places with a clearance of 1: dead ends where one edge ends, else junctions. */
inline TopologyGraph straightWays(const std::vector<Point>& places, const Ends& ends) {
  std::vector<Vertex> vertices;
  for (std::size_t v = 0; v < places.size(); ++v) {
    const auto count = std::count_if(ends.begin(), ends.end(), [&](const auto& edge) {
      return edge.first == v || edge.second == v;
    });
    vertices.push_back({places[v], 1, count == 1 ? kDeadEnd : kJunction, {}});
  }
  return joinedUp(vertices, ends);
}

/** A junction at the origin, vertex 0, with one dead end of each length; clearance 1 everywhere. */
inline TopologyGraph star(const std::vector<double>& lengths) {
  std::vector<Vertex> vertices{{{0, 0}, 1, kJunction, {}}};
  Ends ends;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double angle = 2 * M_PI * double(i) / double(lengths.size());
    vertices.push_back({lengths[i] * Point{std::cos(angle), std::sin(angle)}, 1, kDeadEnd, {}});
    ends.emplace_back(0, i + 1);
  }
  return joinedUp(vertices, ends);
}

/** No dead end leads into another region. */
inline bool leadsNowhere(const Vertex&, const Vertex&) { return false; }

}  // namespace roomgraph::test
