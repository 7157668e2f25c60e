#pragma once
#include "roomgraph/check/RunCheck.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/repair/RepairedRun.h"

namespace roomgraph {

// Ours
// In:   Run and RunCheck
// Out:  RepairedRun
// Next: keyFrameMoves

/** A run laid as it would lie if it agreed with itself (checkRun), in its own frame, whose sound
 *  majority stays where it was. It is left as it was, with the reason, where nothing can be told of
 *  it, where its self error may be none, and where what was seen twice does not bear out how its
 *  parts lie to each other. Slow bends of what was driven once stay: nothing shows them.
 *  Deterministic. O(scans). */
RepairedRun repairAlone(const Run& run, const RunCheck& check);

}  // namespace roomgraph
