#pragma once
#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   Site, Consensus
// Out:  its poses, by what each scan shows where they have it
// Next: repairRuns, mergeRuns, carryPlaces

/** Looks for each scan again in what the others have drawn where the poses of few runs have it, and
 *  solves once more from there: a stretch that its links hold off from where it fits goes there, as
 *  the kernel of a link lets go of it. The graph, what is trusted of it, and the errors of the runs
 *  stay as they are. Of many runs nothing changes. Cost: that of matchAgain for each pair, both
 *  ways, and of one solvePoseGraph from a good start. */
void refinePoses(Consensus& consensus, const Site& site, const MapPairs& pairs,
                 const ForEach& forEach);

}  // namespace roomgraph
