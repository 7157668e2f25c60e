#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/topology/VoronoiGraph.h"

namespace roomgraph {

/** The area of all Delaunay faces of each group [m2]. `groupOf(v)` tells the group of the face of
 *  vertex v, a number below that of the vertices, or VoronoiEdge::kNoVertex for none. Twice the
 *  area of a face is a sum over its Delaunay edges, in which the edges inside of a group cancel.
 *  O(n). */
template <class GroupOf>
[[nodiscard]] std::vector<double> faceAreas(const VoronoiGraph& graph, const GroupOf& groupOf) {
  std::vector<double> area(graph.vertices.size(), 0.0);
  const auto add = [&](std::uint32_t vertex, double part) {
    const std::uint32_t group =
        vertex == VoronoiEdge::kNoVertex ? vertex : std::uint32_t(groupOf(vertex));
    if (group != VoronoiEdge::kNoVertex) area[group] += part;
  };
  for (const VoronoiEdge& edge : graph.edges) {
    const Point origin = graph.obstacles.front();  // keeps the terms small
    const double part =
        cross(graph.obstacles[edge.right] - origin, graph.obstacles[edge.left] - origin) / 2;
    add(edge.source, part);
    add(edge.target, -part);
  }
  return area;
}

}  // namespace roomgraph
