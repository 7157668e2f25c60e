#pragma once
#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>

#include <string>
#include <vector>

namespace roomgraph {

/** What a 3D sensor saw at once. */
struct PointCloud {
  mrpt::poses::CPose3D sensor;  ///< robot <- sensor
  std::string label;            ///< of the sensor; empty for a 3DRangeScan, whose label is not read
  mrpt::Clock::time_point time{};             ///< INVALID_TIMESTAMP for none
  std::vector<mrpt::math::TPoint3Df> points;  ///< sensor frame, all of them finite [m]
  /** Where the points are kept in a file beside the map that is not there: its name. */
  std::string missingFile;
};

}  // namespace roomgraph
