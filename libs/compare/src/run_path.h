#pragma once
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/consensus/map_errors.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

/** The way of the robot in a run that lies at `pose` (site <- run), with the errors of its key
 *  frames. These are left out where no other run bears out where a key frame lies, and where
 *  `error` is that of a copy of the map without scans. */
std::vector<PathPose> runPath(const Run& run, const Transform2D& pose, const MapError& error);

}  // namespace roomgraph
