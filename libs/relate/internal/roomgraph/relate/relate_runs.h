#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/base/PairTable.h"
#include "roomgraph/relate/KeptPairs.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/relate/relate_maps.h"

namespace roomgraph {

// Ours
// In:   the runs
// Out:  MapPair of each pair of runs
// Next: compareRuns

/** MapPair of each two runs; that of a and b is said of the one with the lower index first. */
using MapPairs = PairTable<MapPair>;

/** The run through which all others are related: of those that have seen at least half as much as
 *  the largest, the one with the straightest walls; of equal ones the first. 0 for no runs. */
std::size_t hubOf(const std::vector<Run>& runs);

/** What relateMaps gives for each two runs: first those with the hub, then the others by
 *  relateMapsOver, which saves nearly all of the search. With `areAligned` by relateAlignedMaps.
 *  Pairs that are kept are not worked out again, so that one more run costs its own pairs only,
 *  unless it becomes the hub. The same for any order of the jobs, and with or without kept
 *  pairs. */
MapPairs relateRuns(const std::vector<Run>& runs, bool areAligned, const ForEach& forEach,
                    const KeptPairs& kept = {});

}  // namespace roomgraph
