#include "roomgraph/geometry/principal_axis.h"

#include <cmath>

namespace roomgraph {

PrincipalAxis principalAxis(const PointSums& s) {
  const double n = s.count;
  const double a = s.xx / n - s.x * s.x / n / n, b = s.xy / n - s.x * s.y / n / n,
               c = s.yy / n - s.y * s.y / n / n;
  const double middle = (a + c) / 2, half = std::hypot((a - c) / 2, b);
  return {std::atan2(2 * b, a - c) / 2, middle + half, middle - half};
}

}  // namespace roomgraph
