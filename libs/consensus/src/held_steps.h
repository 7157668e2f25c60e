#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   Site, Consensus
// Out:  the links that its runs hold against it
// Next: findConsensus

/** The links that give way in the consensus though the scans on both sides of them agree with the
 *  step as it was drawn and refute the one that the consensus has: what was found of the run beyond
 *  them lies in a place that only looks like it. None of the reference, of runs without scans, and
 *  of links that are held already. O(scans + links that give way). */
std::vector<PoseEdgeId> heldSteps(const Site& site, const Consensus& consensus,
                                  const ForEach& forEach);

}  // namespace roomgraph
