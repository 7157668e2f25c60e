#pragma once
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** Points joined by straight segments in their order; not closed. */
using Polyline = std::vector<Point>;

/** Sum of the segment lengths [m]; 0 for fewer than two points. O(n). */
double length(const Polyline& line);

/** The place at `along` metres from the first point, clamped to the ends.
 *  `line` must not be empty. O(n). */
Point pointAt(const Polyline& line, double along);

/** The place of the segment a–b that is nearest to `p`. */
Point nearestOnSegment(Point p, Point a, Point b);

/** Distance from `p` to the closed segment a–b [m]; a may equal b. */
double distanceToSegment(Point p, Point a, Point b);

}  // namespace roomgraph
