#pragma once
#include <cmath>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** A place on a wall, and the direction from the wall into the free space in front of it. Both
 *  sides of a thin wall are walls of their own. */
struct WallPoint {
  Point place;   ///< [m, map frame]
  Point normal;  ///< of length 1
};

constexpr int kOctants = 8;  ///< directions that walls are sorted into

/** Which of the 8 directions at multiples of 45 degrees is nearest to that of `v`. */
[[nodiscard]] inline int octantOf(Point v) {
  constexpr double halfOctant = M_SQRT2 - 1;  // its tangent
  const double ax = std::abs(v.x), ay = std::abs(v.y);
  // Looked up, as these comparisons go either way too often to be guessed.
  constexpr signed char kOctant[] = {1, 3, 7, 5, 2, 2, 6, 6, 0, 4, 0, 4, 0, 4, 0, 4};
  const bool isAlongX = ay <= halfOctant * ax, isAlongY = ax <= halfOctant * ay;
  return kOctant[8 * isAlongX + 4 * isAlongY + 2 * (v.y < 0) + (v.x < 0)];
}

}  // namespace roomgraph
