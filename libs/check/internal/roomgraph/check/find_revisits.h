#pragma once
#include <vector>

#include "roomgraph/consensus/PoseGraph.h"
#include "roomgraph/consensus/mend_steps.h"

namespace roomgraph {

// In:   the scans of a run, and about where they lie
// Out:  which scan was found where in what the run drew at another time
// Next: selfConsensus

/** What was found again in one go, as edges of the pose graph of the run, whose nodes are its
 *  scans: from where it was drawn at another time to the scan that was found there. */
using Revisit = std::vector<PoseEdge>;

/** Looks for each scan in the maps that the run has drawn far from it in path, near where `poses`
 *  have it and the farther around the longer the way between. What could lie in several places, or
 *  slide, is left out. Each group is a stretch of scans that was found in one stretch of the run.
 *  Deterministic. O(scans * poses in the window). */
std::vector<Revisit> findRevisits(const std::vector<LocalScan>& scans,
                                  const std::vector<Transform2D>& poses);

}  // namespace roomgraph
