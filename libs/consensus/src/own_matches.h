#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/consensus/match_nodes.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   a run with scans
// Out:  FoundGroup
// Next: findConsensus

/** What a run tells of its own breaks, whatever others have seen: where a scan has next to nothing
 *  in common with the two before it, though it lies beside them as drawn, its step is asked for by
 *  mendSteps. Where that contradicts the run at one step alone, the scans behind it are found in
 *  the scan before it, as the group of one stretch. O(scans * walls^2), and the cost of mendSteps
 *  for those steps. */
std::vector<FoundGroup> ownMatches(const PoseGraph& graph, RunId id, const Run& run);

/** The links that give way in the consensus though the scans on both sides of them agree with the
 *  step as it was drawn and refute the one that the consensus has: what was found of the run beyond
 *  them lies in a place that only looks like it. None of the reference, of runs without scans, and
 *  of links that are held already. O(scans + links that give way). */
std::vector<PoseEdgeId> heldSteps(const Site& site, const Consensus& consensus,
                                  const ForEach& forEach);

}  // namespace roomgraph
