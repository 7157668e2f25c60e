#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/check/RunCheck.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   Run
// Out:  RunCheck
// Next: runCheckJson

/** What a run tells of itself: how far it is from agreeing with itself, where it breaks, what it
 *  has drawn twice, and how much of it was seen twice; see docs/check.md, which has the same
 *  sections. Of a run without scans no error is told and no break, only what its map alone shows.
 *  Deterministic. About 1 s for 300 key frames. */
[[nodiscard]] RunCheck checkRun(const Run& run);

/** What must not be. */
struct CheckGateOptions {
  std::optional<double> maxError;  ///< each run must have a self error, and at most this one [m]
  bool failsOnBreaks = false;      ///< a run has a break
  bool failsOnDoubled = false;     ///< it has drawn a place twice, or laid one over another
};

/** What is wrong with a run, a sentence each; none where it passes. That nothing can be told of
 *  what is asked, as of a run without scans, is a complaint too. */
[[nodiscard]] std::vector<std::string> complaintsOf(const RunCheck& check,
                                                    const CheckGateOptions& options);

}  // namespace roomgraph
