#pragma once
#include <string>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/mrpt_plugin/MappedGraph.h"

namespace roomgraph {

/** The newest layout of the object's bytes. */
constexpr std::uint8_t kGraphBytesVersion = 0;

/** What stands there for an id that is none. */
constexpr std::uint32_t kNoId = 0xffffffff;

/** Throws UsageError where the map has more or fewer cells than its frame calls for. */
void checkMapSize(const MappedGraph& graph);

/** Everything that a MappedGraph holds; its map must have the right size. */
std::string graphBytes(const MappedGraph& graph);

/** Reads graphBytes() back. Throws DataError with one line, beginning with `name`, unless each
 *  count fits the bytes, each id its list, each coordinate is finite and no byte is left over. */
void readGraphBytes(ByteView bytes, const std::string& name, MappedGraph& graph);

}  // namespace roomgraph
