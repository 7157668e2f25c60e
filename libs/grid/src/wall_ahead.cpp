#include "wall_ahead.h"

#include <algorithm>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {
namespace {

/** A wall is so much thicker or thinner than what is in line with it at most. */
constexpr double kThicker = 1.5, kThinner = 2;

bool isSolid(const Grid& grid, Point place) {
  return grid.atOrUnknown(cellAt(place)) != State::free;
}

/** How many steps on from a place all is solid; `most` where more are. */
int solidSteps(const Grid& grid, Point place, Point step, int most) {
  int count = 0;
  while (count < most && isSolid(grid, place + double(count + 1) * step)) ++count;
  return count;
}

}  // namespace

std::optional<Point> acrossGap(const Grid& grid, Point place, Point step, double widest) {
  const auto isInside = [&] { return grid.frame.contains(cellAt(place)); };
  while (isInside() && isSolid(grid, place)) place = place + step;
  for (int gap = 0; isInside() && gap <= widest; ++gap, place = place + step)
    if (isSolid(grid, place)) return place + step;
  return std::nullopt;
}

bool wallGoesOn(const Grid& grid, Point place, Point step, double thickness) {
  if (!grid.frame.contains(cellAt(place)) || !isSolid(grid, place)) return false;
  const int most = int(std::max(kThicker * thickness, thickness + 2));
  const int across = 1 + solidSteps(grid, place, toLeft(step), most) +
                     solidSteps(grid, place, -1 * toLeft(step), most);
  return across <= most && thickness <= kThinner * (across + 1) &&
         1 + solidSteps(grid, place, step, most) >= across;
}

}  // namespace roomgraph
