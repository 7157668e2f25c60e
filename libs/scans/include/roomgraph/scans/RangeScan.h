#pragma once
#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <string>
#include <vector>

namespace roomgraph {

/** A 2D scan as a file has it: what is used of MRPT's CObservation2DRangeScan, which takes several
 *  times the memory and a call for each beam. */
struct RangeScan {
  mrpt::poses::CPose3D sensor;     ///< robot <- sensor
  std::string label;               ///< of the sensor
  mrpt::Clock::time_point time{};  ///< 0 for none, MRPT's INVALID_TIMESTAMP
  float aperture = 0;              ///< [rad]
  float maxRange = 0;              ///< [m]
  bool rightToLeft = true;
  std::vector<float> ranges;          ///< [m]
  std::vector<std::uint8_t> isValid;  ///< one flag per range
};

}  // namespace roomgraph
