#pragma once
#include <vector>

#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

// In:   a pose graph, and where its nodes really lie
// Out:  MapError
// Next: scoreRuns

/** Whether the runs of a site differ in scale, and on which side one of them is. */
enum class ScaleSet {
  one,  ///< all have about the same, or nothing is told
  smaller,
  larger
};

/** How wrong a map is: root mean square displacement of what it has drawn against where it
 *  really lies, after the best turn and shift [m]. */
struct MapError {
  double error = 0;
  double low = 0, high = 0;    ///< an interval that should hold the true error in 80 % of cases
  double seen = 0;             ///< share of what it has drawn that others have, too, 0 to 1
  Transform2D pose;            ///< site <- run, the best turn and shift
  std::vector<double> errors;  ///< of each node, root mean square [m]
  std::vector<bool> isSeen;    ///< of each node: whether others have it, too
  /** Share of what it has drawn that others bear out, and of what they contradict without saying
   *  where it belongs; 0 to 1. */
  double confirmed = 1, contradicted = 0;
  std::vector<bool> isConfirmed;  ///< of each node; empty where nothing was asked
  double givenUp = 0;  ///< share of what it and a reference found of each other that is given up
  double jitter = 0;   ///< how far its key frames lie off each on its own, part of `error` [m]
  double reach = 0;    ///< how far what it has drawn lies from its middle, root mean square [m]
  double scale = 1;    ///< how long it has drawn what the consensus has 1 m long, if that shows
  ScaleSet scaleSet = ScaleSet::one;
};

/** The map error of each run whose nodes lie at `poses` (those of findConsensus). The interval is
 *  wider for few runs and for what others have not seen. No error for a run that has drawn nothing.
 *  O(nodes + edges). */
ById<RunId, MapError> mapErrors(const PoseGraph& graph, const NodePoses& poses);

/** The same of one run, by matches with `others` runs. */
MapError mapError(const PoseGraph& graph, RunId run, const NodePoses& poses, std::size_t others);

}  // namespace roomgraph
