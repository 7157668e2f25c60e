#pragma once
#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>

#include <functional>
#include <string>
#include <vector>

namespace roomgraph {

/** Points as a sensor saw them, all of them finite [m]. */
using CloudPoints = std::vector<mrpt::math::TPoint3Df>;

/** What a 3D sensor saw at once. The points stay as the file has them until they are asked for:
 *  they take most of the time and of the memory, and not everybody wants them. */
struct PointCloud {
  mrpt::poses::CPose3D sensor;     ///< robot <- sensor
  std::string label;               ///< of the sensor; empty for a 3DRangeScan from before MRPT 2.1
  mrpt::Clock::time_point time{};  ///< INVALID_TIMESTAMP for none
  /** Decodes the points, in the frame of the sensor. @throws DataError where they are in a file of
   *  their own that is damaged. */
  std::function<CloudPoints()> points = [] { return CloudPoints(); };
  /** Where the points are kept in a file beside the map that is not there: its name. */
  std::string missingFile;
  /** The folder of such a file where that is named after another map. */
  std::string otherFolder;
};

}  // namespace roomgraph
