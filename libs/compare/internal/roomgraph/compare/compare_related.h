#pragma once
#include <vector>

#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/relate/relate_runs.h"

namespace roomgraph {

/** What of the options is about relating. */
inline RelateRunsOptions relateOptionsOf(const CompareRunsOptions& options) {
  return {options.areAligned, options.reference, options.core};
}

/** compareRuns for runs that are related already, as relateRuns gives it, in the order of sortRuns.
 *  @throws UsageError also where `related` are not those of as many runs. */
Comparison compareRelated(const std::vector<Run>& runs, const MapPairs& related,
                          const CompareRunsOptions& options);

}  // namespace roomgraph
