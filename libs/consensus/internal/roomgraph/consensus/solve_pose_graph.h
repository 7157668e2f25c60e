#pragma once
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

struct PoseGraphSolution {
  NodePoses poses;
  ById<RunId, double> stretches;  ///< of the links of each run, as GraphRun has them
  double cost = 0;
};

/** How much longer the kernels are at first. A rough start needs long ones, a good start none. */
enum class StartIs { rough, good };

/** The poses of all nodes that fit best, by robust least squares (Ceres), from `start` on:
 *  - each link keeps the pose of its nodes to each other, as far as its run's slack allows;
 *  - each match lays two nodes on each other, as far as its group is believed;
 *  - the axes of each node lie along those of the building, a weak prior;
 *  - from a rough start, the links of a run of which that shows are longer or shorter by one
 *    factor, about 1; from a good one they keep GraphRun::stretch.
 *  All count by kernels that let go of what contradicts the rest: a link that gives way is a break
 *  of its run. The first node stays where it is, or all of the reference. Deterministic. About 1 s
 *  for 2500 nodes. */
PoseGraphSolution solvePoseGraph(const PoseGraph& graph, const GraphTrust& trust,
                                 const NodePoses& start, StartIs startIs);

}  // namespace roomgraph
