#include "ClutterGroup.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <utility>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/geometry/principal_axis.h"

namespace roomgraph {

namespace {

/** The first and the last cell of each row, the other way round where it has none. */
std::vector<std::pair<int, int>> rowsOf(const ClutterGroup& group) {
  std::vector<std::pair<int, int>> rows(std::size_t(group.box.height()), {INT_MAX, INT_MIN});
  for (const Cell cell : group.cells) {
    auto& [left, right] = rows[std::size_t(cell.y - group.box.low.y)];
    left = std::min(left, cell.x), right = std::max(right, cell.x);
  }
  return rows;
}

}  // namespace

double sizeOf(const ClutterGroup& group) {
  const std::vector<std::pair<int, int>> rows = rowsOf(group);
  double squares = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = i; j < rows.size(); ++j) {
      const int across = std::max(rows[i].second - rows[j].first, rows[j].second - rows[i].first);
      squares = std::max(squares, squaredNorm({double(across), double(j - i)}));
    }
  return std::sqrt(squares) + 1;
}

std::vector<Point> cornersOf(const ClutterGroup& group) {
  std::vector<Point> corners;
  double y = group.box.low.y;
  for (const auto& [left, right] : rowsOf(group)) {
    if (left <= right)
      for (const double x : {left - 0.5, right + 0.5})
        for (const double side : {-0.5, 0.5}) corners.push_back({x, y + side});
    ++y;
  }
  return corners;
}

Point directionOf(const ClutterGroup& group) {
  PointSums sums;
  for (const Cell cell : group.cells) sums.add({double(cell.x), double(cell.y)});
  const Point way = turned({1, 0}, principalAxis(sums).direction);
  const auto rounded = [](double part) {
    return std::ldexp(std::round(std::ldexp(part, 30)), -30);
  };
  return {rounded(way.x), rounded(way.y)};
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
