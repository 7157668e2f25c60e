#pragma once
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

/** First poses of all nodes where no run is torn: each run lies as a whole (site <- run) where most
 *  of all matches with other runs agree, of the places where one of its groups would have it. The
 *  reference, if any, stays where it is. A run that nothing was found of keeps its own poses.
 *  Deterministic. O(rounds * groups * matches of a run). */
NodePoses wholePoses(const PoseGraph& graph);

}  // namespace roomgraph
