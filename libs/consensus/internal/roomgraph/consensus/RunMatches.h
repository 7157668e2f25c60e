#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/consensus/match_submaps.h"

namespace roomgraph {

/** What of one run was found in another, in one piece. */
struct RunMatches {
  std::size_t of = 0, in = 0;  ///< runs
  std::vector<SubmapMatch> matches;
  double likeness = 0;  ///< see MatchedPiece
};

/** A pose for each submap of each run, site <- submap: [run][submap]. */
using SubmapPoses = std::vector<std::vector<Transform2D>>;

}  // namespace roomgraph
