#include "goes_on.h"

#include <cmath>

#include "RegionGroups.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {
namespace {

/** In steps of a cell, from the one beyond `end` on. */
template <class Visit>
bool isEveryPlaceBeyond(const Grid& grid, Point end, Point other, const Visit& visit) {
  const double width = distance(end, other), step = grid.frame.resolution;
  const Point out = (step / width) * (end - other);
  for (int i = 1; i * step <= width / 2 * (1 + kSameWidth); ++i)
    if (!visit(end + double(i) * out, turned(out, M_PI / 2))) return false;
  return true;
}

}  // namespace

bool goesOn(const Grid& grid, Point end, Point other) {
  return isEveryPlaceBeyond(grid, end, other, [&](Point p, Point) { return !grid.isFree(p); });
}

bool wallGoesOn(const Grid& grid, Point end, Point other) {
  const auto isWall = [&](Point p) {
    return grid.atOrUnknown(grid.frame.cellAt(p)) == State::occupied;
  };
  int places = 0, walls = 0;
  Point last = end, across;  // of the wall
  const bool isClosed = isEveryPlaceBeyond(grid, end, other, [&](Point p, Point aside) {
    ++places, across = aside;
    if (isWall(p)) last = p;
    walls += isWall(p) || isWall(p + aside) || isWall(p - aside) ? 1 : 0;
    return !grid.isFree(p);
  });
  if (!isClosed || 2 * walls < places) return false;
  const int most = 2 * places;  // as the places are those of half of the width
  int thickness = 0;
  for (const Point step : {across, -1 * across})
    for (int i = 1; i <= most && isWall(last + double(i) * step); ++i) ++thickness;
  return thickness < most;
}

}  // namespace roomgraph
