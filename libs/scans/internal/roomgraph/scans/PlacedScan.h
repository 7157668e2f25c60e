#pragma once
#include <mrpt/poses/CPose3D.h>

#include <cstddef>
#include <cstdint>

#include "roomgraph/scans/RangeScan.h"

namespace roomgraph {

/** A level scan of a run, and the place that it is seen from. */
struct PlacedScan {
  mrpt::poses::CPose3D robot;  ///< map <- robot
  mrpt::poses::CPose3D from;   ///< map <- what the scan's sensor counts from: mostly the robot
  RangeScan scan;
  std::size_t keyFrame = 0;  ///< number of its frame in the Recording
  std::uint64_t id = 0;      ///< see Keyframe::scanId
};

}  // namespace roomgraph
