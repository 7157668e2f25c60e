#pragma once
#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** What sums over points tell of them without the points themselves: how many, their sum, and the
 *  sums of their squares and products [m, m2]. */
struct PointSums {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;  ///< sums of products

  void add(Point p) {
    ++count, x += p.x, y += p.y;
    xx += p.x * p.x, xy += p.x * p.y, yy += p.y * p.y;
  }
  [[nodiscard]] Point mean() const { return {x / count, y / count}; }  ///< of one point at least
};

}  // namespace roomgraph
