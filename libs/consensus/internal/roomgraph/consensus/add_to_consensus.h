#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/consensus/map_errors.h"

namespace roomgraph {

// Ours
// In:   the consensus of some runs, and a run that is not among them
// Out:  where that run really lies, and its MapError
// Next: scoreRuns, findBreaks

/** A run beside a consensus. */
struct AddedToConsensus {
  std::vector<Transform2D> poses;  ///< of its submaps, site <- submap
  MapError error;
};

/** Where the submaps of run `added` really lie, as the runs say whose submaps lie at `poses`: what
 *  findConsensus gives where these do not move. `matches` are those of the run and of others; of
 *  them those count that have it on one side, and its map error is that among as many runs as it
 *  has matches with. So a run costs the same however many there are, and others have no say in it.
 *  Deterministic. O(submaps * matches of the run). */
AddedToConsensus addToConsensus(const std::vector<RunSubmaps>& runs, std::size_t added,
                                const std::vector<RunMatches>& matches, const SubmapPoses& poses);

}  // namespace roomgraph
