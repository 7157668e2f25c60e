#pragma once
#include <optional>
#include <string>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

/** "junction", "dead_end", "border", "room" or "ring", as in all files. */
[[nodiscard]] const char* kindName(VertexKind kind);

/** The kind of that name; none for any other text. */
[[nodiscard]] std::optional<VertexKind> kindOfName(const std::string& name);

/** "room" for a path between the vertex of a room and a border vertex, "way" for any other inside
 *  of a room, "corridor" for those outside. */
[[nodiscard]] const char* kindName(const TopologyGraph& graph, const Edge& edge);

}  // namespace roomgraph
