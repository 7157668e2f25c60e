#pragma once
#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>

#include <string>
#include <vector>

#include "roomgraph/scans/mrpt_object.h"

namespace roomgraph {

/** What a 3D sensor saw at once. */
struct PointCloud {
  std::string label;  ///< of the sensor; empty for a 3DRangeScan, whose label is not read
  mrpt::Clock::time_point time{};             ///< INVALID_TIMESTAMP for none
  mrpt::poses::CPose3D sensor;                ///< robot <- sensor
  std::vector<mrpt::math::TPoint3Df> points;  ///< sensor frame, all of them finite [m]
  /** Where the points are kept in a file beside the map that is not there: its name. */
  std::string missingFile;
};

/** Whether readCloud() knows the class: CObservationPointCloud, CObservation3DRangeScan,
 *  CObservationVelodyneScan and CObservationRotatingScan. */
bool isCloudClass(const std::string& className);

/** Reads the points that follow the header of such an observation, wherever they are kept, and
 *  leaves what is behind them. Files beside the map are looked for in NAME_Images, as MOLA writes
 *  them, and beside it. Throws DataError for a newer version, and where anything contradicts the
 *  format. */
PointCloud readCloud(ByteReader& in, const ObjectHeader& header);

}  // namespace roomgraph
