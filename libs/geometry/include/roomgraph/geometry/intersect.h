#pragma once
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** Where the closed segments p–q and a–b meet, as fractions of the way from p to q.
 *  Empty where they do not meet, one number where they meet in a point, the two ends of the
 *  shared piece where they overlap, in increasing order. Whether they meet is decided exactly for
 *  the given coordinates (CGAL's exact kernel); the numbers are rounded once. */
[[nodiscard]] std::vector<double> intersect(Point p, Point q, Point a, Point b);

}  // namespace roomgraph
