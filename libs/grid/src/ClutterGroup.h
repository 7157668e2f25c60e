#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/geometry/Point.h"
#include "roomgraph/grid/CellBox.h"

namespace roomgraph {

/** The cell whose centre is nearest to a place [cells]: as std::lround() does it, but five times as
 *  fast. */
inline Cell cellAt(Point place) {
  constexpr int kBelow = 1 << 20;
  constexpr double kToNearest = kBelow + 0.5;
  return {int(place.x + kToNearest) - kBelow, int(place.y + kToNearest) - kBelow};
}

/** Connected cells that are not free. */
struct ClutterGroup {
  std::vector<Cell> cells;
  CellBox box;
  std::size_t rim = 0, wall = 0;  // cells at free ones, and occupied cells
  double size = 0;                // [cells]

  bool isSeen() const { return 2 * wall >= rim; }
  Point middle() const {
    return 0.5 * Point{double(box.low.x + box.high.x), double(box.low.y + box.high.y)};
  }
};

/** How far apart two of its cells are, with half of each: about the same however it is turned. */
double sizeOf(const ClutterGroup& group);

/** The corners of its cells that may lie on its convex hull [cells]. */
std::vector<Point> cornersOf(const ClutterGroup& group);

/** The direction in which a group is longest, to some 1e-9: so what lies along the rows or columns
 *  does so exactly, however the map is turned. */
Point directionOf(const ClutterGroup& group);

/** How wide a group is across a direction [cells]. */
double widthAcross(const ClutterGroup& group, Point direction);

}  // namespace roomgraph
