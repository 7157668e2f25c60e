#pragma once
#include <vector>

#include "roomgraph/consensus/RunMatches.h"

namespace roomgraph {

// Ours
// In:   the submaps of a run, and where they really lie
// Out:  MapError
// Next: scoreRuns

/** How wrong a map is: root mean square displacement of what it has drawn against where it
 *  really lies, after the best turn and shift [m]. */
struct MapError {
  double error = 0;
  double low = 0, high = 0;    ///< an interval that should hold the true error in 80 % of cases
  double seen = 0;             ///< share of what it has drawn that others have, too, 0 to 1
  Transform2D pose;            ///< site <- run, the best turn and shift
  std::vector<double> errors;  ///< of each submap, root mean square [m]
  std::vector<bool> isSeen;    ///< of each submap: whether others have it, too
};

/** The map error of each run whose submaps lie at `poses` (those of findConsensus). The interval
 *  is wider for few runs and for what others have not seen. No error for a run that has drawn
 *  nothing. O(submaps + matches). */
std::vector<MapError> mapErrors(const std::vector<RunSubmaps>& runs,
                                const std::vector<RunMatches>& matches, const SubmapPoses& poses);

/** Makes up for what fits nowhere: a lost submap (lostScans) is looked for within about a metre of
 *  where the rest of its run has it, so it is taken to be that far off. Its error, that of the run
 *  and the upper end of the interval rise; nothing else changes. O(submaps). */
void addLost(MapError& error, const RunSubmaps& run, const std::vector<bool>& isLost);

}  // namespace roomgraph
