#pragma once
#include <string>

#include "roomgraph/rooms/RoomGraph.h"

namespace roomgraph {

// In:   RoomGraph
// Out:  the text of a GraphML file
// Next: writeFileAtomically

/** The graph as GraphML for networkx, Gephi, yEd and others: undirected, node n3 is vertex 3 and
 *  edge e5 is edge 5; parallel edges and self loops stay. Typed keys, with units in their
 *  descriptions: x, y, kind, clearance, room, area of nodes, kind, room, length, min_clearance of
 *  edges; what a thing does not have is left out. Paths are not in it. Same graph, same bytes. */
[[nodiscard]] std::string graphml(const RoomGraph& graph);

}  // namespace roomgraph
