#pragma once
#include <string>

#include "object_bytes.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/mrpt_plugin/MappedGraph.h"

namespace roomgraph {

constexpr ObjectKind kRoomGraphObject{"CRoomGraph", "room graph", "give a .roomgraph file", 1};

/** Throws UsageError where the map has more or fewer cells than its frame calls for. */
void checkMapSize(const MappedGraph& graph);

/** The graph as graphJson, then the cells of its map, which must be as many as its frame calls
 *  for. */
std::string graphBytes(const MappedGraph& graph);

/** Reads graphBytes() back. Throws DataError with one line, beginning with `name`, unless the
 *  JSON is whole, the cells fit the frame and no byte is left over. */
void readGraphBytes(ByteView bytes, const std::string& name, MappedGraph& graph);

}  // namespace roomgraph
