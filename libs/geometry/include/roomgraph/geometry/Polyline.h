#pragma once
#include <algorithm>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** Points joined by straight segments in their order; not closed. */
using Polyline = std::vector<Point>;

/** Sum of the segment lengths [m]; 0 for fewer than two points. O(n). */
[[nodiscard]] double length(const Polyline& line);

/** The place at `along` metres from the first point, clamped to the ends.
 *  `line` must not be empty. O(n). */
[[nodiscard]] Point pointAt(const Polyline& line, double along);

/** The place of the segment a–b that is nearest to `p`. */
[[nodiscard]] inline Point nearestOnSegment(Point p, Point a,
                                            Point b) {  // here, as it is asked for all edges
  const Point direction = b - a;
  const double squared = squaredNorm(direction);
  if (squared == 0) return a;
  return a + std::clamp(dot(p - a, direction) / squared, 0.0, 1.0) * direction;
}

/** Distance from `p` to the closed segment a–b [m]; a may equal b. */
[[nodiscard]] double distanceToSegment(Point p, Point a, Point b);

}  // namespace roomgraph
