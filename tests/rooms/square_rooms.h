#pragma once
#include <algorithm>

#include "hand_built.h"
#include "roomgraph/rooms/Room.h"

namespace roomgraph::test {

constexpr double kEpsilon = 1e-8;
constexpr double kClearance = 0.5;

/** A room of 4 x 4 m with its lower left corner at (x, y). */
inline Room squareRoom(double x, double y) {
  return {{{{x, y}, {x + 4, y}, {x + 4, y + 4}, {x, y + 4}}, {}}, {x + 2, y + 2}, 2};
}

/** One path along the points, a dead end at both sides. */
inline TopologyGraph line(const Polyline& points) {
  return {
      {{points.front(), 1, VertexKind::deadEnd, {}}, {points.back(), 1, VertexKind::deadEnd, {}}},
      {{VertexId(0), VertexId(1), straight(points), {}}}};
}

/** The same inside of room 0, with a border vertex at both sides. */
inline TopologyGraph wayBetweenBorders(const Polyline& points) {
  return {{{points.front(), 1, VertexKind::border, RoomId(0)},
           {points.back(), 1, VertexKind::border, RoomId(0)}},
          {{VertexId(0), VertexId(1), straight(points), RoomId(0)}}};
}

inline std::size_t countOf(const TopologyGraph& graph, VertexKind kind) {
  return std::size_t(std::count_if(graph.vertices().begin(), graph.vertices().end(),
                                   [&](const Vertex& v) { return v.kind == kind; }));
}

inline std::vector<EdgeId> allEdges(const TopologyGraph& graph) {
  std::vector<EdgeId> edges;
  for (std::size_t e = 0; e < graph.edges().size(); ++e) edges.push_back(EdgeId(e));
  return edges;
}

}  // namespace roomgraph::test
