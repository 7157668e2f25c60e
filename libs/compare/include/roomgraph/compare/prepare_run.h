#pragma once
#include <string>
#include <vector>

#include "roomgraph/pipeline/ExtractOptions.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/scans/Keyframe.h"

namespace roomgraph {

// In:   a map, and the scans that it was made from
// Out:  Run
// Next: compareRuns

/** All that the comparison needs to know of a map: its graph and areas by extract(), its walls
 *  and its scans. `scans` are what loadMap gives; without them breaks are told from the walls
 *  alone. `name` is to be another one for each run.
 *
 *      const ExtractOptions options;
 *      const LoadedMap read = loadMap("monday.simplemap", options.loadGrid);
 *      const Run monday = prepareRun("monday", read.map, read.keyframes, options);
 *
 *  Cost: that of extract().
 *  @throws DataError where no wall stands beside free space. */
[[nodiscard]] Run prepareRun(const std::string& name, const GreyMap& map,
                             const std::vector<Keyframe>& scans, const ExtractOptions& options);

}  // namespace roomgraph
