#pragma once
#include "roomgraph/check/RunCheck.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   Run
// Out:  RunCheck
// Next: runCheckJson

/** What a run tells of itself: how far it is from agreeing with itself, where it breaks, what it
 *  has drawn twice, and how much of it was seen twice; see docs/check.md, which has the same
 *  sections. Of a run without scans no error is told and no break, only what its map alone shows.
 *  Deterministic. About 1 s for 300 key frames. */
[[nodiscard]] RunCheck checkRun(const Run& run);

}  // namespace roomgraph
