#pragma once
#include <mrpt/maps/CSimpleMap.h>

#include <cstdint>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/GreyMap.h"
#include "walk.h"

namespace roomgraph {

// In:   a complete map and the poses of a robot on it
// Out:  what its laser would have measured there

struct SimulateScansOptions {
  int beams = 541;         ///< over 270 degrees
  double maxRange = 15;    ///< [m]
  double noiseStd = 0.01;  ///< of a range [m]
  std::uint32_t seed = 1;
};

/** One key frame per pose, with its true pose and one scan; a second between two frames. Ranges
 *  are rounded to 1/256 m, as lasers round them, so that they compress. */
mrpt::maps::CSimpleMap simulateScans(const GreyMap& map, const std::vector<WalkPose>& poses,
                                     const SimulateScansOptions& options);

/** The same for a robot that believes to be elsewhere: the scans are those of `poses`, the poses of
 *  the key frames are `believed`, as many. */
mrpt::maps::CSimpleMap simulateScans(const GreyMap& map, const std::vector<WalkPose>& poses,
                                     const std::vector<Transform2D>& believed,
                                     const SimulateScansOptions& options);

}  // namespace roomgraph
