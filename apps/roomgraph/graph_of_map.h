#pragma once
#include <string>

#include "roomgraph/graph_files/GraphFile.h"
#include "roomgraph/pipeline/ExtractOptions.h"

namespace roomgraph {

/** The graph in an X.json of 'roomgraph extract', or else that of a map, extracted now. Throws
 *  DataError with one line for what is neither. */
GraphFile graphOfMap(const std::string& file, const ExtractOptions& options);

/** "R3" for a room, "C7" for a corridor by the number of its area, "nowhere" for none. */
std::string areaName(const GraphFile& file, AreaId area);

}  // namespace roomgraph
