#pragma once
#include <string>

#include "roomgraph/mrpt_plugin/MappedGraph.h"

namespace roomgraph {

/** What a `.roomgraph` file holds, see loadRoomGraph(); it needs nothing of MRPT.
 *  @throws DataError with one line (file, problem, remedy). */
MappedGraph readRoomGraph(const std::string& path);

}  // namespace roomgraph
