#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/RunMatches.h"

namespace roomgraph {

// Ours
// In:   the submaps of all runs of a site, and which was found where
// Out:  Consensus
// Next: mapErrors, findBreaks

/** What the submaps' poses may be. */
struct ConsensusPoses {
  SubmapPoses best;
  std::vector<SubmapPoses> others;  ///< that explain the site about as well
};

struct ConsensusOptions {
  std::optional<std::size_t> reference;  ///< a run that is taken for the truth
  std::size_t pivots = 3;      ///< runs from whose frame the consensus is looked for, at most
  ForEach forEach = oneByOne;  ///< changes no number
};

/** Where the submaps of all runs really lie, as all runs together have it: the solution of one
 *  robust pose graph, in which each run holds its submaps together and the matches hold the runs
 *  together. It is solved from the frames of the first `pivots` runs, or from that of the
 *  reference, and from where no run is torn. Each of `matches` is believed as far as the poses bear
 *  it out, all of it together, and pieces of runs that lie in the wrong one of places alike are
 *  moved. The best solution is refined once: runs whose links hardly gave way are trusted more;
 *  runs that share their scans err alike, so their agreement does not make them that much more
 *  trusted. `runs` should be ordered with the likeliest first. A run that nothing was found of
 *  keeps its own poses, in its own frame. The frame is that of the best pivot, or of the reference.
 *  Deterministic. About 1 s for each pivot with ten runs of 250 key frames. (Robust pose graphs:
 *  Agarwal et al. 2013; reweighting by variance components.) */
ConsensusPoses findConsensus(const std::vector<RunSubmaps>& runs,
                             const std::vector<RunMatches>& matches,
                             const ConsensusOptions& options);

}  // namespace roomgraph
