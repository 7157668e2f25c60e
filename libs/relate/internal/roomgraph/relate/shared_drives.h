#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   the runs
// Out:  which of them are of one drive
// Next: placeRuns, summarize

/** The runs that share the scans of one drive, see `sharesDrive`: sets of two or more, ascending.
 *  Of two runs the scans of the shorter one count, without those that show nothing. Runs without
 *  scans share none. O(scans * runs of a drive). */
std::vector<std::vector<std::size_t>> sharedDrives(const std::vector<const Run*>& runs);

/** Whether a run of so many scans is of one drive with runs that have `same` of them, too: several
 *  programs over one log, for example. */
inline bool sharesDrive(std::size_t same, std::size_t scans) {
  constexpr double kShared = 0.2;
  return double(same) > kShared * double(scans);
}

/** Two runs with the same scans show the same site, however badly their maps fit each other as
 *  rigid bodies: those that were related, share a drive (see sharedDrives), and are not joined yet,
 *  lie in each other as their common scans do, surely, and are followed from there on. O(scans) for
 *  each such pair, and followWalls. */
void joinDrives(MapPairs& related, const std::vector<Run>& runs, const ForEach& forEach);

}  // namespace roomgraph
