#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/breaks/ScanBreak.h"

namespace roomgraph {

// Ours
// In:   where the scans of a run really lie
// Out:  ScanBreak
// Next: siteBreaks

/** Where the poses of a run's scans jump from one scan to the next, while they are steady before
 *  and after; and, however unsteady they are, where they turn or shift by so much in a few scans
 *  that no noise does it, and stay so. A drift is no break. By scan. None within two scans of
 *  either end. Cost: O(scans * window). */
std::vector<ScanBreak> findBreaks(const std::vector<ScanWalls>& scans, const ScanTrack& track,
                                  const FindBreaksOptions& options);

/** Where a run tore that the consensus has torn before the scan `found`. Of scans that no other run
 *  has seen (`isSeen`, by scan) the consensus cannot tell on which side of the break they lie. So
 *  of all places among them that is taken where a scan has least of the walls of the one before, by
 *  the run's own poses; `found` where that is not plain. At most five scans away. O(walls^2). */
std::size_t placeBreak(const std::vector<ScanWalls>& scans, const std::vector<bool>& isSeen,
                       std::size_t found);

}  // namespace roomgraph
