#pragma once
#include <cmath>
#include <vector>

#include "roomgraph/scans/PlacedScan.h"

namespace roomgraph::test {

/** A robot that drives round a bend, with a scanner of 20 beams in front. */
inline std::vector<PlacedScan> sampleDrive(std::size_t count) {
  std::vector<PlacedScan> drive;
  for (std::size_t k = 0; k < count; ++k) {
    PlacedScan one;
    const double turn = 0.3 * double(k);
    one.keyFrame = k;
    one.from = {3 + 2 * std::sin(turn), -1 + 2 * std::cos(turn), 0, -turn, 0, 0};
    one.scan.time = mrpt::Clock::fromDouble(1.7e9 + double(k));
    one.scan.label = "laser";
    one.scan.aperture = float(M_PI);
    one.scan.sensor = {0.2, 0, 0.4, 0, 0, 0};
    for (std::size_t i = 0; i < 20; ++i) {
      one.scan.ranges.push_back(1.5f + 0.01f * float(i + k));
      one.scan.isValid.push_back(i != k % 20);
    }
    drive.push_back(one);
  }
  return drive;
}

}  // namespace roomgraph::test
