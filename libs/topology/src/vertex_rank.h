#pragma once
#include <utility>

#include "roomgraph/geometry/PointSums.h"

namespace roomgraph {

/** The mean place of some vertices, at least one [m]: it turns with the map. */
template <class Vertices>
Point middleOf(const Vertices& vertices) {
  PointSums sums;
  for (const auto& vertex : vertices) sums.add(vertex.place);
  return sums.mean();
}

/** Of several vertices the one with the least rank stands for all: that with most space, and of
 *  those with as much the nearest to a middle of the graph. Floats, as rounding must not decide:
 *  the map's pose would. */
template <class Vertex>
std::pair<float, float> vertexRank(const Vertex& vertex, Point middle) {
  return {-float(vertex.clearance), float(distance(vertex.place, middle))};
}

}  // namespace roomgraph
