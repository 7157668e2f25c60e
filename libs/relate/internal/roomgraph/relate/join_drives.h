#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   MapPair of pairs of runs, and the runs
// Out:  the same, with those of one drive joined
// Next: placeRuns

/** Two runs with the same scans show the same site, however badly their maps fit each other as
 *  rigid bodies: those that were related, share a drive (see sharedDrives), and are not joined yet,
 *  lie in each other as their common scans do, surely, and are followed from there on. O(scans) for
 *  each such pair, and followWalls. */
void joinDrives(MapPairs& related, const std::vector<Run>& runs, const ForEach& forEach);

}  // namespace roomgraph
