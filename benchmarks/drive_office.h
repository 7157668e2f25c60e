#pragma once
#include <mrpt/maps/CSimpleMap.h>

#include <cstdint>
#include <vector>

#include "drift.h"
#include "roomgraph/geometry/Point.h"
#include "roomgraph/grid/GreyMap.h"
#include "walk.h"

namespace roomgraph {

// In:   a complete map drawn with the levels of FloorPlan.h, and the corners of a way through it
// Out:  what a robot brings home that drives through it

/** A simplemap, and where its key frames really are. */
struct OfficeDrive {
  mrpt::maps::CSimpleMap frames;
  std::vector<WalkPose> truth;
};

struct DriveOfficeOptions {
  std::uint32_t seed = 1;     ///< of the laser
  double metresPerFrame = 2;  ///< of the way between two key frames
  double turn = 0;            ///< of the run's frame [rad]
  DriftOptions drift;
};

/** Scans on the way, and poses that drift. Throws UsageError where there are less than two corners:
 *  the map has no room for a robot. */
OfficeDrive driveOffice(const GreyMap& office, const std::vector<Point>& corners,
                        const DriveOfficeOptions& options);

}  // namespace roomgraph
