#pragma once
#include <cmath>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

constexpr double kOtherTurn = 0.15, kOtherPlace = 1.0;  // poses that are not the same answer

/** Whether two poses turn alike, and carry `at` to about the same place. */
inline bool areNear(const Transform2D& l, const Transform2D& r, Point at, double turn,
                    double place) {
  return std::abs(wrappedAngle(l.phi - r.phi)) < turn && distance(l(at), r(at)) < place;
}

}  // namespace roomgraph
