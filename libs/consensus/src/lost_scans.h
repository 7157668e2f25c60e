#pragma once
#include <vector>

#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   Site, Consensus
// Out:  of each run which of its scans are lost
// Next: addLost

/** Of each scan of each run whether it was found in no other run, though at least three to which
 *  its run was related know most of the place: it does not lie where the run and its consensus have
 *  it. Stray scans do not count, only at least three on end; nor do those of the reference. Runs
 *  without scans have none. Copies of a map say nothing of each other. O(scans that nobody has *
 *  runs). */
ById<RunId, std::vector<bool>> lostScans(const Site& site, const MapPairs& pairs,
                                         const Consensus& consensus);

}  // namespace roomgraph
