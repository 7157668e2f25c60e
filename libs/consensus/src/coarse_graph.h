#pragma once
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

// In:   PoseGraph
// Out:  CoarseGraph
// Next: solvePoseGraph, finePoses

/** A pose graph with fewer nodes: up to four key frames of a run that follow each other are one,
 *  that of the first, where no match group of the run begins or ends between them, or finds them
 *  differently. Patches stay as they are. */
struct CoarseGraph {
  PoseGraph graph;                ///< without what its nodes drew; with all match groups
  ById<NodeId, NodeId> coarseOf;  ///< of each node that of `graph`
};

/** O(nodes + edges). */
CoarseGraph coarseGraph(const PoseGraph& graph);

/** The poses of the coarse nodes: those of the first key frame of each. */
NodePoses coarsePoses(const CoarseGraph& coarse, const NodePoses& poses);

/** The poses of all nodes where their coarse ones have them: `shape` tells how those of one coarse
 *  node lie to each other. */
NodePoses finePoses(const CoarseGraph& coarse, const NodePoses& shape, const NodePoses& poses);

}  // namespace roomgraph
