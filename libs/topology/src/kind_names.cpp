#include "roomgraph/topology/kind_names.h"

#include <algorithm>

namespace roomgraph {
namespace {

constexpr VertexKind kKinds[] = {VertexKind::junction, VertexKind::deadEnd, VertexKind::border,
                                 VertexKind::room, VertexKind::ring};

}  // namespace

const char* kindName(VertexKind kind) {
  switch (kind) {
    case VertexKind::junction:
      return "junction";
    case VertexKind::deadEnd:
      return "dead_end";
    case VertexKind::border:
      return "border";
    case VertexKind::room:
      return "room";
    case VertexKind::ring:
      return "ring";
  }
  return "";
}

std::optional<VertexKind> kindOfName(const std::string& name) {
  for (const VertexKind kind : kKinds)
    if (name == kindName(kind)) return kind;
  return std::nullopt;
}

const char* kindName(const TopologyGraph& graph, const Edge& edge) {
  if (!edge.room) return "corridor";
  const VertexKind source = graph.vertex(edge.source).kind, target = graph.vertex(edge.target).kind;
  const bool isSpoke =
      std::minmax(source, target) == std::minmax(VertexKind::border, VertexKind::room);
  return isSpoke ? "room" : "way";
}

}  // namespace roomgraph
