#pragma once
#include <string>
#include <vector>

#include "roomgraph/grid/LoadGridOptions.h"
#include "roomgraph/scans/RobotScan.h"

namespace roomgraph {

// In:   a simplemap
// Out:  RobotScan
// Next: rawlogBytes

/** The scans of loadKeyframes, one for each of its key frames, with all that MRPT's programs want
 *  to know of them. Checks as loadGrid does. O(file).
 *  @throws DataError where the file is missing or damaged. */
[[nodiscard]] std::vector<RobotScan> loadScans(const std::string& file,
                                               const LoadGridOptions& options);

}  // namespace roomgraph
