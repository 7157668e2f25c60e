#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/consensus/RunMatches.h"

namespace roomgraph {

/** First poses of all submaps in the frame of the run `pivot`: each where it was found in the
 *  pivot, else in a run that has been placed, else where the nearest submap of its own run that
 *  was found would have it. Runs are placed by how many of their submaps were found in those
 *  placed before. One that was found nowhere keeps its own poses. O(runs^2 * matches). */
SubmapPoses startPoses(const std::vector<RunSubmaps>& runs, const std::vector<RunMatches>& matches,
                       std::size_t pivot);

}  // namespace roomgraph
