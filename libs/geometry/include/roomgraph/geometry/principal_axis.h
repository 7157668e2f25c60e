#pragma once
#include "roomgraph/geometry/PointSums.h"

namespace roomgraph {

/** The line along which points lie. */
struct PrincipalAxis {
  double direction = 0;  ///< from -pi/2 to pi/2 [rad]
  double along = 0;      ///< variance along it [m2]
  double across = 0;     ///< variance across it, not above that along it [m2]
};

/** Of one point or more; any direction where they lie as widely in all. O(1). */
[[nodiscard]] PrincipalAxis principalAxis(const PointSums& sums);

}  // namespace roomgraph
