#pragma once
#include <string>

#include "roomgraph/mrpt_plugin/CRoomGraph.h"

namespace roomgraph {

// In:   CRoomGraph
// Out:  the bytes of a .roomgraph file, and back
// Next: writeFileAtomically

/** The bytes of a `.roomgraph` file: the gzipped MRPT stream of the one object, as RawLogViewer
 *  opens it with `-l libroomgraph_mrpt.so`. The same graph gives the same bytes.
 *  @throws UsageError where the map has more or fewer cells than its frame calls for. */
[[nodiscard]] std::string roomGraphBytes(const CRoomGraph& graph);

/** Reads a `.roomgraph` file back, gzipped or not: the very same graph. Checksum, sizes, ids and
 *  numbers are checked before they are used, and nothing may follow the object.
 *  @throws DataError with one line (file, problem, remedy). */
[[nodiscard]] CRoomGraph loadRoomGraph(const std::string& path);

}  // namespace roomgraph
