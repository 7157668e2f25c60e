#include "goes_on.h"

#include "RegionGroups.h"

namespace roomgraph {
namespace {

/** In steps of a cell, from the one beyond `end` on. */
template <class Visit>
bool isEveryPlaceBeyond(const Grid& grid, Point end, Point other, const Visit& visit) {
  const double width = distance(end, other), step = grid.frame.resolution;
  const Point out = (step / width) * (end - other);
  for (int i = 1; i * step <= width / 2 * (1 + kSameWidth); ++i)
    if (!visit(end + double(i) * out, Point{-out.y, out.x})) return false;
  return true;
}

/** Of what goes on, so that nothing there is free. */
bool isMostlyWall(const Grid& grid, Point end, Point other) {
  const auto isWall = [&](Point p) {
    return grid.atOrUnknown(grid.frame.cellAt(p)) == State::occupied;
  };
  int places = 0, walls = 0;
  Point last = end, across;  // of the wall
  isEveryPlaceBeyond(grid, end, other, [&](Point p, Point aside) {
    ++places, across = aside;
    if (isWall(p)) last = p;
    walls += isWall(p) || isWall(p + aside) || isWall(p - aside) ? 1 : 0;
    return true;
  });
  if (2 * walls < places) return false;
  const int most = 2 * places;  // as the places are those of half of the width
  int thickness = 0;
  for (const Point step : {across, -1 * across})
    for (int i = 1; i <= most && isWall(last + double(i) * step); ++i) ++thickness;
  return thickness < most;
}

/** How far it is free from a place on in a direction of one cell [cells]. */
int freeRun(const Grid& grid, Point start, Point step) {
  int count = 0;
  while (grid.isFree(start + double(count + 1) * step)) ++count;
  return count;
}

}  // namespace

bool goesOn(const Grid& grid, Point end, Point other) {
  return isEveryPlaceBeyond(grid, end, other, [&](Point p, Point) { return !grid.isFree(p); });
}

bool isInWall(const Grid& grid, Point from, Point to) {
  return goesOn(grid, from, to) && goesOn(grid, to, from) && isMostlyWall(grid, from, to) &&
         isMostlyWall(grid, to, from);
}

bool isInLongSide(const Grid& grid, Point from, Point to, double elongation) {
  const Point along = (grid.frame.resolution / distance(from, to)) * (to - from);
  const Point out{-along.y, along.x}, middle = midpoint(from, to);
  const int depths[] = {freeRun(grid, middle, out), freeRun(grid, middle, -1 * out)};
  for (const int side : {0, 1}) {
    const Point inside = middle + (side == 0 ? 0.5 : -0.5) * double(depths[side]) * out;
    const int length = 1 + freeRun(grid, inside, along) + freeRun(grid, inside, -1 * along);
    if (length > elongation * depths[side] && length > depths[1 - side]) return true;
  }
  return false;
}

}  // namespace roomgraph
