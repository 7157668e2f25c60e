#pragma once
#include <optional>

#include "roomgraph/graph_files/GraphFile.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

/** What a room graph of MRPT holds, without MRPT. */
struct MappedGraph {
  GraphFile file;           ///< the graph and where it comes from
  std::optional<Grid> map;  ///< drawn under the graph; its frame is that of `file`
};

}  // namespace roomgraph
