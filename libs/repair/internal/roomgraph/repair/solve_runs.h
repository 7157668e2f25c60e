#pragma once
#include <vector>

#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/consensus/site_consensus.h"

namespace roomgraph {

/** relateRuns and solveSite, one after the other; `areOneSite` as in the former. `runs` must
 *  outlive the result, which names them. */
SolvedSite solveRuns(const std::vector<Run>& runs, const CompareRunsOptions& options,
                     bool areOneSite = false);

}  // namespace roomgraph
