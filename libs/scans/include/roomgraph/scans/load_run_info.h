#pragma once
#include <optional>
#include <string>

#include "roomgraph/scans/RunInfo.h"

namespace roomgraph {

// In:   a simplemap
// Out:  RunInfo
// Next: -

/** None for a file that is no simplemap. O(file).
 *  @throws DataError where the file is missing or damaged. */
[[nodiscard]] std::optional<RunInfo> loadRunInfo(const std::string& file);

}  // namespace roomgraph
