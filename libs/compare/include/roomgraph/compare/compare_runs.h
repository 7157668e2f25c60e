#pragma once
#include <vector>

#include "roomgraph/compare/CompareRunsOptions.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   the runs, as prepareRun makes them
// Out:  Comparison
// Next: comparisonJson, comparisonReport

/** Relates the runs, places them in one frame, scores and measures each, and says which is best.
 *  The site is the largest set of runs that are joined by pairs of the same site (that of the
 *  reference, if any); runs outside of it are left out. A single run gets no score. The same for
 *  any order of the runs.
 *
 *      std::vector<Run> runs{prepareRun("monday", ...), prepareRun("tuesday", ...)};
 *      const Comparison comparison = compareRuns(runs, {});
 *      const std::string best = comparison.runs.front().name;
 *
 *  O(runs * walls), and with the square of the runs up to `core` of them.
 *  @throws UsageError where there is no such reference, or two runs have one name. */
Comparison compareRuns(std::vector<Run> runs, const CompareRunsOptions& options);

}  // namespace roomgraph
