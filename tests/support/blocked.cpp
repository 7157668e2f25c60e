#include "blocked.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace roomgraph::test {

std::string textOf(Point p) {
  std::ostringstream out;
  out << " at (" << p.x << ", " << p.y << ")";
  return out.str();
}

bool isBlockedOutside(const Grid& grid) {
  return std::find(grid.cells.begin(), grid.cells.end(), State::unknown) != grid.cells.end();
}

double distanceToBlocked(const Grid& grid, bool outsideIsBlocked, Point p, double limit) {
  const double resolution = grid.frame.resolution;
  const int reach = int(std::ceil(limit / resolution)) + 1;
  const int cx = int(std::floor((p.x - grid.frame.origin.x) / resolution));
  const int cy = int(std::floor((p.y - grid.frame.origin.y) / resolution));
  double nearest = limit;
  for (int y = cy - reach; y <= cy + reach; ++y)
    for (int x = cx - reach; x <= cx + reach; ++x) {
      const Cell cell{x, y};
      const bool isBlocked =
          grid.frame.contains(cell) ? grid.at(cell) != State::free : outsideIsBlocked;
      if (isBlocked) nearest = std::min(nearest, distance(p, grid.frame.center(cell)));
    }
  return nearest;
}

}  // namespace roomgraph::test
