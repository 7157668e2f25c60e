#pragma once
#include <vector>

#include "roomgraph/consensus/map_errors.h"

namespace roomgraph {

// In:   the consensus of some runs, and a run that is not among them
// Out:  where that run really lies, and its MapError
// Next: scoreRuns, findBreaks

/** A run beside a consensus. */
struct AddedToConsensus {
  std::vector<Transform2D> poses;  ///< of its nodes, site <- node
  double stretch = 1, slack = 1;   ///< of its links; with which they were solved
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
