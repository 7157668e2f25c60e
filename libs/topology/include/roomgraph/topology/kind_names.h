#pragma once
#include <array>

#include "roomgraph/base/enum_names.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

[[nodiscard]] constexpr std::array<const char*, 5> enumNames(VertexKind) {
  return {"junction", "dead_end", "border", "room", "ring"};
}

/** "room" for a path between the vertex of a room and a border vertex, "way" for any other inside
 *  of a room, "corridor" for those outside. */
[[nodiscard]] const char* kindName(const TopologyGraph& graph, const Edge& edge);

}  // namespace roomgraph
