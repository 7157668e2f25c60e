#pragma once
#include <string>
#include <vector>

#include "roomgraph/grid/LoadGridOptions.h"
#include "roomgraph/scans/Keyframe.h"

namespace roomgraph {

// In:   a simplemap
// Out:  Keyframes
// Next: scanWalls

/** The horizontal 2D range scans of a simplemap, or, as loadGrid has it, the slices of its point
 *  clouds, in the order of the file; empty for every other kind of map. Beams without return or
 *  longer than options.maxDistanceInsertion are left out. Checks as loadGrid does. O(file).
 *  @throws DataError where the file is missing or damaged. */
[[nodiscard]] std::vector<Keyframe> loadKeyframes(const std::string& file,
                                                  const LoadGridOptions& options);
/** The same with the default options but for the longest range [m]. */
[[nodiscard]] std::vector<Keyframe> loadKeyframes(const std::string& file, double maxRange);

}  // namespace roomgraph
