#include "roomgraph/grid/ObstacleRows.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "roomgraph/geometry/Polyline.h"

namespace roomgraph {

namespace {

/** The columns of a row in which a cell may be no farther than `reach` from the segment; none where
 *  first > second. */
std::pair<int, int> columnsNear(const GridFrame& frame, int row, Point a, Point b, double reach) {
  double begin = 0, end = 1;
  if (const double rise = b.y - a.y; rise != 0) {
    const double middle = frame.center({0, row}).y - a.y, margin = reach + frame.resolution;
    std::tie(begin, end) = std::minmax({(middle - margin) / rise, (middle + margin) / rise});
    begin = std::max(begin, 0.0), end = std::min(end, 1.0);
    if (begin > end) return {1, 0};
  }
  const auto [low, high] = std::minmax({a.x + begin * (b.x - a.x), a.x + end * (b.x - a.x)});
  return {frame.cellAt(Point{low - reach, a.y}).x - 1,
          frame.cellAt(Point{high + reach, a.y}).x + 1};
}

}  // namespace

ObstacleRows::ObstacleRows(const ObstacleCells& obstacles)
    : obstacles_(obstacles), firstInRow_(std::size_t(obstacles.frame.height) + 3) {
  std::size_t next = 0;
  for (std::size_t row = 0; row < firstInRow_.size(); ++row) {
    while (next < obstacles.cells.size() && obstacles.cells[next].y < int(row) - 1) ++next;
    firstInRow_[row] = next;
  }
}

double ObstacleRows::clearance(Point a, Point b, double limit, double enough) const {
  const GridFrame& frame = obstacles_.frame;
  const Point reach{limit, limit};
  const Cell low = frame.cellAt(Point{std::min(a.x, b.x), std::min(a.y, b.y)} - reach);
  const Cell high = frame.cellAt(Point{std::max(a.x, b.x), std::max(a.y, b.y)} + reach);
  const std::pair<int, int> all{low.x, high.x};
  const bool isLong = std::abs(b.x - a.x) > 2 * limit;  // then most of the box is far from it
  double nearest = limit;
  const std::ptrdiff_t end = std::min(high.y, frame.height) + 1;
  for (std::ptrdiff_t y = std::max(low.y, -1); y < end && nearest >= enough; ++y) {
    const auto rowEnd = obstacles_.cells.begin() + std::ptrdiff_t(firstInRow_[std::size_t(y + 2)]);
    auto it = obstacles_.cells.begin() + std::ptrdiff_t(firstInRow_[std::size_t(y + 1)]);
    const auto [first, last] = isLong ? columnsNear(frame, int(y), a, b, nearest) : all;
    it = std::lower_bound(it, rowEnd, first, [](Cell cell, int x) { return cell.x < x; });
    for (; it != rowEnd && it->x <= last; ++it)
      nearest = std::min(nearest, distanceToSegment(frame.center(*it), a, b));
  }
  return nearest;
}

}  // namespace roomgraph
