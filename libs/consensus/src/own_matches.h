#pragma once
#include <vector>

#include "roomgraph/consensus/match_nodes.h"

namespace roomgraph {

// Ours
// In:   a run with scans
// Out:  FoundGroup
// Next: findConsensus

/** Of which steps a run is asked: of breaks between long stretches others tell more surely, where
 *  there are enough of them. */
enum class AskedSteps { all, nearEnds };

/** What a run tells of its own breaks, whatever others have seen: where a scan has next to nothing
 *  in common with the two before it, though it lies beside them as drawn, its step is asked for by
 *  mendSteps. Where that contradicts the run at one step alone, the scans behind it are found in
 *  the scan before it, as the group of one stretch. O(scans * walls^2), and the cost of mendSteps
 *  for those steps. */
std::vector<FoundGroup> ownMatches(const PoseGraph& graph, RunId id, const Run& run,
                                   AskedSteps steps);

}  // namespace roomgraph
