#pragma once
#include <cmath>
#include <vector>

#include "roomgraph/scans/load_scans.h"

namespace roomgraph::test {

/** A robot that drives round a bend, with a scanner of 20 beams in front. */
inline std::vector<RobotScan> sampleDrive(std::size_t count) {
  std::vector<RobotScan> drive;
  for (std::size_t k = 0; k < count; ++k) {
    RobotScan one;
    const double turn = 0.3 * double(k);
    one.keyFrame = k;
    one.robot = {3 + 2 * std::sin(turn), -1 + 2 * std::cos(turn), 0, -turn, 0, 0};
    one.scan.timestamp = mrpt::Clock::fromDouble(1.7e9 + double(k));
    one.scan.sensorLabel = "laser";
    one.scan.aperture = float(M_PI);
    one.scan.sensorPose = {0.2, 0, 0.4, 0, 0, 0};
    one.scan.resizeScan(20);
    for (std::size_t i = 0; i < 20; ++i) {
      one.scan.setScanRange(i, 1.5f + 0.01f * float(i + k));
      one.scan.setScanRangeValidity(i, i != k % 20);
    }
    drive.push_back(one);
  }
  return drive;
}

}  // namespace roomgraph::test
