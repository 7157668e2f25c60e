#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/scan_walls.h"

namespace roomgraph {

// Ours
// In:   the scans of a run, and a break among them
// Out:  the first scan behind the break
// Next: siteBreaks

/** Where a run tore that the consensus has torn before the scan `found`. Of scans that no other run
 *  has seen (`isSeen`, by scan) the consensus cannot tell on which side of the break they lie. So
 *  of all places among them that is taken where a scan has least of the walls of the one before, by
 *  the run's own poses; `found` where that is not plain. At most five scans away. O(walls^2). */
std::size_t placeBreak(const std::vector<ScanWalls>& scans, const std::vector<bool>& isSeen,
                       std::size_t found);

}  // namespace roomgraph
