#pragma once
#include "roomgraph/consensus/PoseGraph.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   Run
// Out:  its nodes and links in a PoseGraph
// Next: drawnBy, matchNodes, findConsensus

/** Adds a run to a graph that has no matches yet: its key frames where it has scans, else its wall
 *  patches. O(scans), or O(walls). */
RunId addRunNodes(const Run& run, PoseGraph& graph);

}  // namespace roomgraph
