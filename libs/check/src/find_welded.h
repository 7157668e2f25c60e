#pragma once
#include <vector>

#include "beams_through_walls.h"
#include "roomgraph/check/RunCheck.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   BeamsThroughWalls of the run as drawn, and of its self-consensus
// Out:  WeldedPlace
// Next: RunCheck

/** The places that the run has laid over each other though they are not one: where several
 *  scans beside each other see through most of the walls of another time, as drawn and as the run
 *  would agree with itself, which has not parted them. The largest first. O(overlaid^2). */
std::vector<WeldedPlace> findWelded(const Run& run, const BeamsThroughWalls& drawn,
                                    const BeamsThroughWalls& agreed);

}  // namespace roomgraph
