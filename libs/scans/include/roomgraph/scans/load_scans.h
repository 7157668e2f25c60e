#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3D.h>

#include <cstddef>
#include <string>
#include <vector>

#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

// In:   a simplemap
// Out:  RobotScan
// Next: rawlogBytes

/** A scan as MRPT has it, and from where it was taken. */
struct RobotScan {
  std::size_t keyFrame = 0;    ///< number of its key frame, see Keyframe
  mrpt::poses::CPose3D robot;  ///< map <- robot; the scan's own pose counts from it
  mrpt::obs::CObservation2DRangeScan scan;
};

/** The scans of loadKeyframes, one for each of its key frames, with all that MRPT's programs want
 *  to know of them. Checks as loadGrid does. O(file).
 *  @throws DataError where the file is missing or damaged. */
std::vector<RobotScan> loadScans(const std::string& file, const LoadGridOptions& options);

}  // namespace roomgraph
