#pragma once
#include <vector>

#include "roomgraph/topology/shortest_ways.h"

namespace roomgraph {

/** The vertex at a place on a path: the path's end where it lies there, else a new one of `kind`
 *  that parts the edge; the part from its source keeps the number. */
VertexId splitAt(std::vector<Vertex>& vertices, std::vector<Edge>& edges, PlaceOnPath place,
                 VertexKind kind);

}  // namespace roomgraph
