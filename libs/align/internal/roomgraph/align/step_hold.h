#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/scan_walls.h"

namespace roomgraph {

// In:   the scans of a run
// Out:  how far they support each of its steps
// Next: trackScans, lookAgain

/** How far the scans of a run support the step to scan `k`: 1 where it has walls in common with
 *  one of the two before it as scans have that follow each other, 0 where nothing fits, as behind a
 *  break, or where a robot was carried. 1 for the first scan, and behind the last. O(walls^2). */
double stepHold(const std::vector<ScanWalls>& scans, std::size_t k);

}  // namespace roomgraph
