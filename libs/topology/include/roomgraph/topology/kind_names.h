#pragma once
#include <optional>
#include <string>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

/** "junction", "dead_end", "border", "room" or "ring", as in all files. */
[[nodiscard]] const char* kindName(VertexKind kind);

/** The kind of that name; none for any other text. */
[[nodiscard]] std::optional<VertexKind> kindOfName(const std::string& name);

/** "room" for a path inside of a room, "corridor" for any other. */
[[nodiscard]] const char* kindName(const Edge& edge);

}  // namespace roomgraph
