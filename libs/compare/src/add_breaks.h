#pragma once
#include <vector>

#include "place_runs.h"

namespace roomgraph {

/** Looks for breaks in all runs that carry scans, by tracking these in the runs that are trusted
 *  most. `site` must have its trust. */
void addBreaks(Comparison& result, const PlacedRuns& site,
               const std::vector<std::vector<MapPair>>& pairs, const CompareRunsOptions& options);

}  // namespace roomgraph
