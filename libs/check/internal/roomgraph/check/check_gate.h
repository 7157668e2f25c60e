#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/check/RunCheck.h"

namespace roomgraph {

// Ours
// In:   RunCheck
// Out:  what is wrong with it
// Next: the end of a job

/** What must not be. */
struct CheckGateOptions {
  std::optional<double> maxError;  ///< each run must have a self error, and at most this one [m]
  bool failsOnBreaks = false;      ///< a run has a break
  bool failsOnDoubled = false;     ///< it has drawn a place twice, or laid one over another
};

/** What is wrong with a run, a sentence each; none where it passes. Where nothing can be told of a
 *  run that must have a self error, that is a complaint. */
std::vector<std::string> complaintsOf(const RunCheck& check, const CheckGateOptions& options);

}  // namespace roomgraph
