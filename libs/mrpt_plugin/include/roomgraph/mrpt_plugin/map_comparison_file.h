#pragma once
#include <string>

#include "roomgraph/mrpt_plugin/CMapComparison.h"

namespace roomgraph {

// In:   CMapComparison
// Out:  the bytes of comparison.roomgraph, and back
// Next: writeFileAtomically

/** The bytes of a `.roomgraph` file: the gzipped MRPT stream of the one object, as RawLogViewer
 *  opens it with `-l libroomgraph_mrpt.so`. The same comparison gives the same bytes. */
[[nodiscard]] std::string mapComparisonBytes(const CMapComparison& comparison);

/** Reads such a file back, gzipped or not. Counts and numbers are checked before they are used, and
 *  nothing may follow the object.
 *  @throws DataError with one line (file, problem, remedy). */
[[nodiscard]] CMapComparison loadMapComparison(const std::string& path);

}  // namespace roomgraph
