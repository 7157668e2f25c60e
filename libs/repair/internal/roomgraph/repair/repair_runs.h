#pragma once
#include <vector>

#include "roomgraph/check/RunCheck.h"
#include "roomgraph/consensus/site_consensus.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/repair/RepairedRun.h"
#include "roomgraph/repair/rejoin_pieces.h"

namespace roomgraph {

// In:   SolvedSite, RealPoses
// Out:  RepairedRun of each run that has scans
// Next: keyFrameMoves, mergeRuns

/** Puts the key frames of each run of the site where all runs together have them, in the run's own
 *  frame. A run is left as it was where its error may be zero, by its interval, where others have
 *  not seen enough of it (isTrusted), where it fits them in two ways, where its beams refute that
 *  (findRefuted), or where its scans would fit what the others have seen no better. In the order of
 *  the site. O(scans). */
std::vector<RepairedRun> repairRuns(const SolvedSite& solved, const RealPoses& real);

/** Whether others have seen enough of a run to tell where it really lies: most of it, or so much
 *  that the rest cannot be as far off as a break would move it. */
bool isTrusted(const MapError& error);

/** Whether a run may lie in the site in two ways of which one has it far off, the other sound. */
bool fitsInTwoWays(const MapError& error);

/** A run laid as it would lie if it agreed with itself (checkRun), in its own frame, whose sound
 *  majority stays where it was. It is left as it was, with the reason, where nothing can be told of
 *  it, where its self error may be zero, and where what was seen twice does not bear out how its
 *  parts lie to each other. Slow bends of what was driven once stay: nothing shows them.
 *  Deterministic. O(scans). */
RepairedRun repairAlone(const Run& run, const RunCheck& check);

}  // namespace roomgraph
