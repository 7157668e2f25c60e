#pragma once
#include <optional>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// In:   what was not found of a run, and another map
// Out:  where it may lie there
// Next: trackScans

/** Where a run may lie in the map `in` (in <- run) by what was not found of it in `track`: each
 *  long stretch of scans without a pose that begins or ends where the run's own scans part, as
 *  where a robot was carried or its map is torn, draws a map of its own, which is laid on all of
 *  the other. None where all was found, and for stretches that go on smoothly from what was: these
 *  lie where the other has not been. Cost: that of alignMaps for each such stretch. */
std::vector<Transform2D> lookAgain(const std::vector<ScanWalls>& scans,
                                   const std::vector<std::optional<Transform2D>>& track,
                                   const WallMap& in);

}  // namespace roomgraph
