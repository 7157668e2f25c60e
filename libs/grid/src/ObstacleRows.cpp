#include "roomgraph/grid/ObstacleRows.h"

#include <algorithm>

#include "roomgraph/geometry/Polyline.h"

namespace roomgraph {

ObstacleRows::ObstacleRows(const ObstacleCells& obstacles)
    : obstacles_(obstacles), firstInRow_(std::size_t(obstacles.frame.height) + 3) {
  std::size_t next = 0;
  for (std::size_t row = 0; row < firstInRow_.size(); ++row) {
    while (next < obstacles.cells.size() && obstacles.cells[next].y < int(row) - 1) ++next;
    firstInRow_[row] = next;
  }
}

double ObstacleRows::clearance(Point a, Point b, double limit) const {
  const GridFrame& frame = obstacles_.frame;
  const Point reach{limit, limit};
  const Cell low = frame.cellAt(Point{std::min(a.x, b.x), std::min(a.y, b.y)} - reach);
  const Cell high = frame.cellAt(Point{std::max(a.x, b.x), std::max(a.y, b.y)} + reach);
  double nearest = limit;
  for (std::ptrdiff_t y = std::max(low.y, -1); y <= std::min(high.y, frame.height); ++y) {
    const auto rowEnd = obstacles_.cells.begin() + std::ptrdiff_t(firstInRow_[std::size_t(y + 2)]);
    auto it = obstacles_.cells.begin() + std::ptrdiff_t(firstInRow_[std::size_t(y + 1)]);
    it = std::lower_bound(it, rowEnd, low.x, [](Cell cell, int x) { return cell.x < x; });
    for (; it != rowEnd && it->x <= high.x; ++it)
      nearest = std::min(nearest, distanceToSegment(frame.center(*it), a, b));
  }
  return nearest;
}

}  // namespace roomgraph
