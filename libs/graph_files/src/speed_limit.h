#pragma once
#include <algorithm>
#include <cmath>

namespace roomgraph {

/** Robots may go at full speed this far from obstacles [m]. */
constexpr double kFullSpeedClearance = 1;

/** Share of full speed at a clearance [m, %]: in proportion below, but never less than 20 %. */
inline double speedPercent(double clearance) {
  return std::clamp(std::round(100 * clearance / kFullSpeedClearance), 20.0, 100.0);
}

}  // namespace roomgraph
