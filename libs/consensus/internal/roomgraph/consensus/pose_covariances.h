#pragma once
#include <vector>

#include "roomgraph/consensus/PoseGraph.h"
#include "roomgraph/geometry/PlanarCovariance.h"

namespace roomgraph {

// In:   PoseGraph and the solution of it
// Out:  how sure the poses of its runs are
// Next: repairRuns

/** How sure `poses` are of each node of some runs, in its order, along the axes of their frame
 *  [m, rad]: as if it were known where the run lies as a whole, by the turn and shift that fit its
 *  places best. So the middle of a run is surer than its ends. By the normal equations of the last
 *  step of the solution; what contradicts the rest, and the axes of nodes, say nothing. Those of
 *  some 60 nodes of a run are computed, those between interpolated. O(the factor of the normal
 *  equations * runs): of a graph of 2500 nodes half a second for each run. (Free-network
 *  adjustment: Meissl 1962.) */
std::vector<std::vector<PlanarCovariance>> poseCovariances(const PoseGraph& graph,
                                                           const GraphTrust& trust,
                                                           const NodePoses& poses,
                                                           const std::vector<RunId>& runs);

}  // namespace roomgraph
