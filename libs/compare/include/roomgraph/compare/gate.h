#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// Ours
// In:   Comparison
// Out:  what is wrong with it
// Next: the end of a nightly job

/** What must not be. */
struct GateOptions {
  std::optional<double> minScore;  ///< each run must have a score, and this one at least
  bool failsOnCoverage = false;    ///< a run has seen less than kPartialCoverage
  bool failsOnBreaks = false;      ///< a run has a break
  bool failsOnOtherSites = false;  ///< a run is of another site

  bool asksNothing() const {
    return !minScore && !failsOnCoverage && !failsOnBreaks && !failsOnOtherSites;
  }
};

/** The complaints are "run: what is wrong". Scores and coverage count as they are, meaningful or
 *  not; a reference needs neither. */
GateVerdict gateVerdict(const Comparison& comparison, const GateOptions& options);

}  // namespace roomgraph
