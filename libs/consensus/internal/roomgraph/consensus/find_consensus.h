#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/PoseGraph.h"
#include "roomgraph/consensus/map_errors.h"

namespace roomgraph {

// Ours
// In:   PoseGraph of all runs of a site
// Out:  ConsensusPoses
// Next: mapErrors, findBreaks

/** What the nodes' poses may be. */
struct ConsensusPoses {
  NodePoses best;
  GraphTrust trust;               ///< with which `best` was solved
  std::vector<NodePoses> others;  ///< that explain the site about as well
};

/** Where the nodes of all runs really lie, as all runs together have it: the solution of one robust
 *  pose graph, in which each run holds its nodes together and the matches hold the runs together.
 *  It is solved from the frames of the first three runs, or from that of the reference, and from
 *  where no run is torn. Each match group is believed as far as its matches are inliers, all of it
 *  together, and stretches of runs that lie in the wrong one of places alike are moved. The best
 *  solution is refined once: runs whose links hardly gave way are trusted more. The runs should be
 *  ordered with the likeliest first. A run that nothing was found of keeps its own poses, in its
 *  own frame. The frame is that of the best pivot, or of the reference. `forEach` changes no
 *  number. Deterministic. About 1 s for each start with ten runs of 250 key frames. (Robust pose
 *  graphs: Agarwal et al. 2013; reweighting by variance components.) */
ConsensusPoses findConsensus(const PoseGraph& graph, const ForEach& forEach = oneByOne);

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

/** A run beside a consensus. */
struct AddedToConsensus {
  std::vector<Transform2D> poses;  ///< of its nodes, site <- node
  double slack = 1;                ///< with which they were solved
  MapError error;
};

/** Where the nodes of run `added` really lie, as the runs say whose nodes lie at `poses`: what
 *  findConsensus gives where these do not move. Of all matches those of `groups` count, which join
 *  the run and others; its map error is that among as many runs as it has matches with. So a run
 *  costs the same however many there are, and others have no say in it. Deterministic. O(nodes *
 *  matches of the run). */
AddedToConsensus addToConsensus(const PoseGraph& graph, RunId added,
                                const std::vector<MatchGroupId>& groups, const NodePoses& poses);

}  // namespace roomgraph
