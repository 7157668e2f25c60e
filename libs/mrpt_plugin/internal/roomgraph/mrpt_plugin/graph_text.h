#pragma once
#include <string>

#include "roomgraph/graph_files/GraphFile.h"

namespace roomgraph {

/** The graph as a page of plain text: its map, how many vertices and edges there are of each kind,
 *  the length of all paths, a table of the rooms and the notes. Metres, map frame; the same in
 *  every locale. O(size of the graph). */
std::string graphText(const GraphFile& file);

}  // namespace roomgraph
