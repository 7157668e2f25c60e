#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

// In:   PoseGraph of all runs of a site
// Out:  ConsensusPoses
// Next: mapErrors, findBreaks

/** Of up to so many runs each key frame tells; of more, a coarse graph is solved first. */
constexpr std::size_t kFewRuns = 5;

/** What the nodes' poses may be. */
struct ConsensusPoses {
  NodePoses best;
  ById<RunId, double> stretches;  ///< of the links of each run, as GraphRun has them
  GraphTrust trust;               ///< with which `best` was solved
  std::vector<NodePoses> others;  ///< that explain the site about as well
};

/** Where the nodes of all runs really lie, as all runs together have it: the solution of one robust
 *  pose graph, in which each run holds its nodes together and the matches hold the runs together.
 *  It is solved from the frames of the first three runs, or from that of the reference, and from
 *  where no run is torn. Each match group is believed as far as its matches are inliers, all of it
 *  together, and stretches of runs that lie in the wrong one of places alike are moved. The links
 *  of a run that is too large or too small get the scale of the others, if there are two or a
 *  reference. The best solution is refined once: runs whose links hardly gave way are trusted more.
 *  The runs should be ordered with the likeliest first. A run that nothing was found of keeps its
 *  own poses, in its own frame. The frame is that of the best pivot, or of the reference. `forEach`
 *  changes no number. Deterministic. About 1 s for each start with ten runs of 250 key frames.
 *  (Robust pose graphs: Agarwal et al. 2013; reweighting by variance components.) */
ConsensusPoses findConsensus(const PoseGraph& graph, const ForEach& forEach = oneByOne);

}  // namespace roomgraph
