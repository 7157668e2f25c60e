#pragma once
#include <initializer_list>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

/** A graph of vertices without edges. */
inline TopologyGraph places(std::initializer_list<Point> points) {
  std::vector<Vertex> vertices;
  for (const Point p : points) vertices.push_back({p, 0, VertexKind::junction, RoomId::none()});
  return {vertices, {}};
}

}  // namespace roomgraph
