#pragma once
#include <vector>

#include "roomgraph/consensus/PoseGraph.h"
#include "roomgraph/scans/move_poses.h"

namespace roomgraph {

// Ours
// In:   PoseGraph and the solution of it
// Out:  how sure the poses of one run are
// Next: repairRuns

/** How sure `poses` are of each node of a run, in its order, along the axes of their frame
 *  [m, rad]: as if it were known where the run lies as a whole, by the turn and shift that fit its
 *  places best. So the middle of a run is surer than its ends. By the normal equations of the last
 *  step of the solution; what contradicts the rest, and the axes of nodes, say nothing. Those of
 *  some 60 nodes are computed, those between interpolated. O(60 * factor of the normal equations),
 *  0.5 s for a graph of 2500 nodes. (Free-network adjustment: Meissl 1962.) */
std::vector<PlanarCovariance> poseCovariances(const PoseGraph& graph, const GraphTrust& trust,
                                              const NodePoses& poses, RunId run);

}  // namespace roomgraph
