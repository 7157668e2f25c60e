#pragma once
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/breaks/ScanBreak.h"

namespace roomgraph {

// In:   where the scans of a run really lie
// Out:  ScanBreak
// Next: siteBreaks

/** Where the poses of a run's scans jump from one scan to the next, while they are steady before
 *  and after; and, however unsteady they are, where they turn or shift by so much in a few scans
 *  that no noise does it, and stay so. A drift is no break. By scan. None within two scans of
 *  either end. Cost: O(scans * window). */
std::vector<ScanBreak> findBreaks(const std::vector<ScanWalls>& scans, const ScanTrack& track,
                                  const FindBreaksOptions& options);

}  // namespace roomgraph
