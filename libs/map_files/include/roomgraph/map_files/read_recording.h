#pragma once
#include <optional>
#include <string>

#include "roomgraph/scans/Recording.h"

namespace roomgraph {

// In:   the name of a map file
// Out:  Recording
// Next: placeScans

/** What the run recorded that the map is from; none where a map of this kind has no scans. Checks
 *  as loadGrid does. O(file). @throws DataError where the file is missing or damaged. */
[[nodiscard]] std::optional<Recording> readRecording(const std::string& file);

}  // namespace roomgraph
