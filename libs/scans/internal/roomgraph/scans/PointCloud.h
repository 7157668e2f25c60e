#pragma once
#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/base/byte_reader.h"

namespace roomgraph {

/** The packets of a laser scanner as it sends them, in the bytes of the file that they are from. */
struct VelodynePackets {
  static constexpr std::size_t kPacketSize = 1206, kLaserSize = 72;  ///< of one [bytes]

  ByteView packets, lasers;           ///< what was sent, and how each laser is mounted
  double minRange = 0, maxRange = 0;  ///< [m]
};

/** What a 3D sensor saw at once. */
struct PointCloud {
  mrpt::poses::CPose3D sensor;     ///< robot <- sensor
  std::string label;               ///< of the sensor; empty for a 3DRangeScan from before MRPT 2.1
  mrpt::Clock::time_point time{};  ///< INVALID_TIMESTAMP for none
  std::vector<mrpt::math::TPoint3Df> points;  ///< sensor frame, all of them finite [m]
  std::optional<VelodynePackets> packets;     ///< in place of points, see velodynePoints()
  /** Where the points are kept in a file beside the map that is not there: its name. */
  std::string missingFile;
};

}  // namespace roomgraph
