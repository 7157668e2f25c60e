#include "goes_on.h"

#include <algorithm>
#include <cmath>

#include "RegionGroups.h"

namespace roomgraph {
namespace {

/** One cell out of an opening, in line with it. */
Point stepOut(const Grid& grid, Point end, Point other) {
  return (grid.frame.resolution / distance(end, other)) * (end - other);
}

/** Half of an opening's width [cells]. */
int halfWidth(const Grid& grid, Point end, Point other) {
  return int(distance(end, other) / 2 / grid.frame.resolution * (1 + kSameWidth));
}

/** Both of its ends. */
bool areMostlyWall(const Grid& grid, Point from, Point to) {
  return isMostlyWall(grid, from, to) && isMostlyWall(grid, to, from);
}

/** As goesOn, to a cell on either side. */
bool goesOnNearby(const Grid& grid, Point end, Point other) {
  const Point out = stepOut(grid, end, other), across = toLeft(out);
  const int places = halfWidth(grid, end, other);
  for (int i = 1; i <= places; ++i) {
    const Point p = end + double(i) * out;
    if (grid.isFree(p) && grid.isFree(p + across) && grid.isFree(p - across)) return false;
  }
  return true;
}

}  // namespace

bool isNowhereFree(const Grid& grid, Point start, Point step, int count) {
  for (int i = 1; i <= count; ++i)
    if (grid.isFree(start + double(i) * step)) return false;
  return true;
}

double freeRun(const Grid& grid, Point start, Point step) {
  double cells = 0;
  while (grid.isFree(start + (cells + 0.5) * step)) cells += 0.5;
  return cells;
}

bool goesOn(const Grid& grid, Point end, Point other) {
  return isNowhereFree(grid, end, stepOut(grid, end, other), halfWidth(grid, end, other));
}

bool isMostlyWall(const Grid& grid, Point end, Point other) {
  const auto isWall = [&](Point p) {
    return grid.atOrUnknown(grid.frame.cellAt(p)) == State::occupied;
  };
  const Point out = stepOut(grid, end, other), across = toLeft(out);
  const int places = halfWidth(grid, end, other);
  int walls = 0;
  Point last = end;
  for (int i = 1; i <= places; ++i) {
    const Point p = end + double(i) * out;
    if (isWall(p)) last = p;
    walls += isWall(p) || isWall(p + across) || isWall(p - across) ? 1 : 0;
  }
  if (2 * walls < places) return false;
  const int most = 2 * places;  // as the places are those of half of the width
  int thickness = 0;
  for (const Point step : {across, -1 * across})
    for (int i = 1; i <= most && isWall(last + double(i) * step); ++i) ++thickness;
  return thickness < most;
}

bool isInWall(const Grid& grid, Point from, Point to) {
  return goesOn(grid, from, to) && goesOn(grid, to, from) && areMostlyWall(grid, from, to);
}

bool isInRoughWall(const Grid& grid, Point from, Point to) {
  return goesOnNearby(grid, from, to) && goesOnNearby(grid, to, from) &&
         areMostlyWall(grid, from, to);
}

bool isInLongSide(const Grid& grid, Point from, Point to, double elongation) {
  const Point along = stepOut(grid, to, from), out = toLeft(along), middle = midpoint(from, to);
  const double depths[] = {freeRun(grid, middle, out), freeRun(grid, middle, -1 * out)};
  for (const int side : {0, 1}) {
    const Point inside = middle + (side == 0 ? 0.5 : -0.5) * depths[side] * out;
    const double length = 1 + freeRun(grid, inside, along) + freeRun(grid, inside, -1 * along);
    if (length > elongation * depths[side] && length > depths[1 - side]) return true;
  }
  return false;
}

bool isAcrossOneWidth(const Grid& grid, Point from, Point to) {
  const Point along = stepOut(grid, to, from), middle = midpoint(from, to);
  const Point out = double(halfWidth(grid, to, from)) * toLeft(along);
  const auto lengthAt = [&](Point p) {
    return 1 + freeRun(grid, p, along) + freeRun(grid, p, -1 * along);
  };
  // Twice, as there may be another opening in a wall that goes off.
  const auto width = [&](double side) {
    return std::min(lengthAt(middle + side * out), lengthAt(middle + 2 * side * out));
  };
  const auto [least, most] = std::minmax({width(1), width(-1)});
  return most <= std::sqrt(2.0) * least;
}

}  // namespace roomgraph
