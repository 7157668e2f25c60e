#pragma once
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

/** First poses of all nodes in the frame of the run `pivot`: each where it was found in the pivot,
 *  else in a run that has been placed, else where the nearest node of its own run that was found
 *  would have it. Runs are placed by how many of their nodes were found in those placed before. One
 *  that was found nowhere keeps its own poses. O(runs * (runs + edges)). */
NodePoses startPoses(const PoseGraph& graph, RunId pivot);

/** First poses of all nodes where no run is torn: each run lies as a whole (site <- run) where most
 *  of all matches with other runs agree, of the places where one of its groups would have it. The
 *  reference, if any, stays where it is. A run that nothing was found of keeps its own poses.
 *  Deterministic. O(runs * groups * matches of a run). */
NodePoses wholePoses(const PoseGraph& graph);

}  // namespace roomgraph
