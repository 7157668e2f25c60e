#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   the runs
// Out:  which of them are of one drive
// Next: joinDrives, summarize

/** The runs that share the scans of one drive, see `sharesDrive`: sets of two or more, ascending.
 *  Of two runs the scans of the shorter one count, without those that show nothing. Runs without
 *  scans share none. O(scans * runs of a drive). */
std::vector<std::vector<std::size_t>> sharedDrives(const std::vector<const Run*>& runs);

}  // namespace roomgraph
