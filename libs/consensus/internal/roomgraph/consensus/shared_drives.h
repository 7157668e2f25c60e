#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   the runs of a site
// Out:  which of them are of one drive
// Next: summarize

/** Share of the scans of the shorter of two runs that both must have, to be of one drive. */
constexpr double kSharedDrive = 0.2;

/** The runs that share the scans of one drive, as several programs over one log do: sets of two or
 *  more, ascending. Runs without scans share none. O(scans), and
 *  O(scans) more for each two runs that have one in common and are not known to be of one drive. */
std::vector<std::vector<std::size_t>> sharedDrives(const std::vector<const Run*>& runs);

}  // namespace roomgraph
