#include "roomgraph/align/WallPoint.h"

#include <cmath>

namespace roomgraph {

int octantOf(Point v) {
  constexpr double kTan22 = 0.41421356237309503;  // of half an octant
  const double ax = std::abs(v.x), ay = std::abs(v.y);
  if (ay <= kTan22 * ax) return v.x >= 0 ? 0 : 4;
  if (ax <= kTan22 * ay) return v.y >= 0 ? 2 : 6;
  if (v.y >= 0) return v.x >= 0 ? 1 : 3;
  return v.x >= 0 ? 7 : 5;
}

}  // namespace roomgraph
