#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/consensus/RunMatches.h"

namespace roomgraph {

// Ours
// In:   RunSubmaps, RunMatches
// Out:  CoarseGraph
// Next: solvePoseGraph, finePoses

/** The nodes of a pose graph, fewer of them: up to four key frames of a run that follow each other
 *  are one submap, that of the first, where no piece of the run begins or ends between them, or
 *  finds them differently. Patches stay as they are. */
struct CoarseGraph {
  std::vector<RunSubmaps> runs;     ///< without what they drew
  std::vector<RunMatches> matches;  ///< between the coarse submaps, as many as there were
  std::vector<std::vector<std::uint32_t>> nodeOf;  ///< [run][submap]: a submap of `runs`
};

/** O(submaps + matches). */
CoarseGraph coarseGraph(const std::vector<RunSubmaps>& runs,
                        const std::vector<RunMatches>& matches);

/** The poses of the coarse submaps: those of the first key frame of each. */
SubmapPoses coarsePoses(const CoarseGraph& coarse, const SubmapPoses& poses);

/** The poses of all submaps where their coarse ones have them: `shape` tells how those of one
 *  coarse submap lie to each other. */
SubmapPoses finePoses(const CoarseGraph& coarse, const SubmapPoses& shape,
                      const SubmapPoses& poses);

}  // namespace roomgraph
