#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/WallMap.h"

namespace roomgraph {

// In:   some scans of a run, and where they lie
// Out:  WallMap
// Next: findScan

/** The map that a few scans draw: what walls and free space can be looked up in, without patches
 *  and all that a whole map tells of itself. `chosen` are places in `scans`, which lie at `poses`
 *  (map <- robot); walls farther than `range` [m] from the robot, where beams are too far apart
 *  to draw them, are left out. Without walls where the scans have none there. O(walls + cells
 *  within `range`). */
WallMap scanMap(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& poses,
                const std::vector<std::size_t>& chosen, double range = 15);

/** The map that successive scans of a run draw, from `first` to before `end`, in the frame of the
 *  run: with all that alignMaps needs. Cost: that of scanMap and addLookUp. */
WallMap stretchMap(const std::vector<ScanWalls>& scans, std::size_t first, std::size_t end);

}  // namespace roomgraph
