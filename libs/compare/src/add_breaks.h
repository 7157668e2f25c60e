#pragma once
#include <vector>

#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/relate/PlacedRuns.h"

namespace roomgraph {

/** Looks for breaks in all runs, in the maps of the runs that are trusted most: where the scans of
 * a run jump, or whether a run without scans has two rigid pieces. More than half of these maps
 * must show a break. `site` must have its trust. */
void addBreaks(Comparison& result, const PlacedRuns& site,
               const std::vector<std::vector<MapPair>>& pairs, const CompareRunsOptions& options);

}  // namespace roomgraph
