#include "ClutterGroup.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <utility>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/geometry/principal_axis.h"

namespace roomgraph {

double sizeOf(const ClutterGroup& group) {
  std::vector<std::pair<int, int>> rows(std::size_t(group.box.height()), {INT_MAX, INT_MIN});
  for (const Cell cell : group.cells) {
    auto& [left, right] = rows[std::size_t(cell.y - group.box.low.y)];
    left = std::min(left, cell.x), right = std::max(right, cell.x);
  }
  double squares = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = i; j < rows.size(); ++j) {
      const int across = std::max(rows[i].second - rows[j].first, rows[j].second - rows[i].first);
      squares = std::max(squares, squaredNorm({double(across), double(j - i)}));
    }
  return std::sqrt(squares) + 1;
}

Point directionOf(const ClutterGroup& group) {
  PointSums sums;
  for (const Cell cell : group.cells) sums.add({double(cell.x), double(cell.y)});
  return turned({1, 0}, principalAxis(sums).direction);
}

double widthAcross(const ClutterGroup& group, Point direction) {
  double low = 0, high = 0;
  for (const Cell cell : group.cells) {
    const double place = cross(direction, Point{double(cell.x), double(cell.y)} - group.middle());
    low = std::min(low, place), high = std::max(high, place);
  }
  return high - low + 1;
}

}  // namespace roomgraph
