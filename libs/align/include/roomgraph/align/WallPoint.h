#pragma once
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
[[nodiscard]] int octantOf(Point v);

}  // namespace roomgraph
