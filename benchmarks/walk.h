#pragma once
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** Where a robot is and looks to. */
struct WalkPose {
  Point place;         ///< [m, map frame]
  double heading = 0;  ///< [rad], along the way
};

/** `count` (at least 2) poses at equal distances along the corners of a way. */
std::vector<WalkPose> walk(const std::vector<Point>& corners, int count);

}  // namespace roomgraph
