#include "roomgraph/topology/kind_names.h"

#include <algorithm>

namespace roomgraph {

const char* kindName(const TopologyGraph& graph, const Edge& edge) {
  if (!edge.room) return "corridor";
  const VertexKind source = graph.vertex(edge.source).kind, target = graph.vertex(edge.target).kind;
  const bool isSpoke =
      std::minmax(source, target) == std::minmax(VertexKind::border, VertexKind::room);
  return isSpoke ? "room" : "way";
}

}  // namespace roomgraph
