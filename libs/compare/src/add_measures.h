#pragma once
#include <vector>

#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/relate/PlacedRuns.h"

namespace roomgraph {

/** Appends to the measures of the runs and pairs of a site what their graphs, and each map by
 *  itself, tell: graphMeasuresOf, brokennessOf, ownMeasuresOf. The runs and pairs of `result` must
 *  be there, in any order; its breaks, too. */
void addMeasures(Comparison& result, const PlacedRuns& site,
                 const std::vector<std::vector<MapPair>>& pairs, const ForEach& forEach);

}  // namespace roomgraph
