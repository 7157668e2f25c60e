#pragma once
#include "roomgraph/consensus/Consensus.h"

namespace roomgraph {

// Ours
// In:   Consensus
// Out:  how large each run has drawn the site, in its MapError
// Next: scoreRuns

/** Tells of each run how long it has drawn what the consensus has 1 m long: odometry, or a lidar,
 *  that counts too much makes all of a map too large, and is no bend. Where the runs fall into two
 *  sets that differ by half a percent or more, and by three times what either set spans, the larger
 *  set is not right for being larger, as one robot may have driven all of it: unless one set is a
 *  single run of four or more, the interval of each run is extended so that either may be right,
 *  and its `scaleSet` says to which it belongs. Nothing is told of runs of which less than half is
 *  confirmed, nor beside a reference. O(nodes + runs * log runs). */
void tellScales(Consensus& consensus);

}  // namespace roomgraph
