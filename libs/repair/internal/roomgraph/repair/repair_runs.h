#pragma once
#include <vector>

#include "roomgraph/consensus/solve_site.h"
#include "roomgraph/repair/RepairedRun.h"
#include "roomgraph/repair/rejoin_pieces.h"

namespace roomgraph {

// Ours
// In:   SolvedSite, RealPoses
// Out:  RepairedRun of each run that has scans
// Next: keyFrameMoves, mergeRuns

/** Puts the key frames of each run of the site where all runs together have them, in the run's own
 *  frame. A run is left as it was where its error may be none, by its interval, where less than
 *  half of what it has drawn has been seen by others, or where its scans would fit what the others
 *  have seen no better. In the order of the site. O(scans). */
std::vector<RepairedRun> repairRuns(const SolvedSite& solved, const RealPoses& real);

/** Whether others have seen enough of a run to tell where it really lies. */
bool isTrusted(const MapError& error);

}  // namespace roomgraph
