#include "roomgraph/topology/kind_names.h"

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

const char* kindName(const Edge& edge) { return edge.room ? "room" : "corridor"; }

}  // namespace roomgraph
