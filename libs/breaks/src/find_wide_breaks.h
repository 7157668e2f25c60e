#pragma once
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/breaks/ScanBreak.h"

namespace roomgraph {

// Ours
// In:   where the scans of a run really lie
// Out:  the breaks that are too wide for noise
// Next: findBreaks

/** In so many steps a break may come about; as many on either side bear it out, and are quiet
 *  around a sharp one. */
constexpr std::size_t kFewSteps = 3;

/** Where the poses of a run's scans turn or shift too far for any noise, in one step or in a few,
 *  and stay so: at least kApartRotation or kApartShift. The sharpest first, and of those that are
 *  one only the sharpest. O(scans * steps^2). */
std::vector<ScanBreak> findWideBreaks(const std::vector<ScanWalls>& scans, const ScanTrack& track,
                                      const FindBreaksOptions& options);

/** Whether two breaks begin or end within a few scans of each other. */
bool areOne(const ScanBreak& l, const ScanBreak& r);

}  // namespace roomgraph
