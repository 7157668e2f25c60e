#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3D.h>

#include <cstddef>

namespace roomgraph {

/** A scan as MRPT has it, and from where it was taken. */
struct RobotScan {
  std::size_t keyFrame = 0;                 ///< number of its key frame, see Keyframe
  mrpt::poses::CPose3D robot;               ///< map <- robot; the scan's own pose counts from it
  mrpt::obs::CObservation2DRangeScan scan;  ///< as MRPT has it
};

}  // namespace roomgraph
