#include "roomgraph/grid/polygon_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomgraph {
namespace {

/** Where rows of cell centres enter and leave the polygon, by row and then by x. Each edge is asked
 *  for its own rows only: a long corridor has as many points as rows. */
std::vector<std::pair<int, double>> crossings(const Polygon& polygon, const GridFrame& frame) {
  std::vector<std::pair<int, double>> found;  // row, x
  forEachEdge(polygon, [&](Point a, Point b) {
    const int low = std::max(0, frame.cellAt({a.x, std::min(a.y, b.y)}).y);
    const int high = std::min(frame.height - 1, frame.cellAt({a.x, std::max(a.y, b.y)}).y);
    for (int row = low; row <= high; ++row) {
      const double y = frame.center({0, row}).y;
      if ((a.y <= y) != (b.y <= y))
        found.push_back({row, a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)});
    }
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::vector<Cell> cellsIn(const Polygon& polygon, const GridFrame& frame) {
  std::vector<Cell> cells;
  if (polygon.outer.empty()) return cells;
  const auto column = [&](double x) {  // the first whose centre is not left of x
    const double c = std::ceil((x - frame.origin.x) / frame.resolution - 0.5);
    return int(std::clamp(c, 0.0, double(frame.width)));
  };
  const std::vector<std::pair<int, double>> sides = crossings(polygon, frame);
  for (std::size_t k = 0; k + 1 < sides.size(); k += 2)  // each row is entered as often as left
    for (int x = column(sides[k].second); x < column(sides[k + 1].second); ++x)
      cells.push_back({x, sides[k].first});
  return cells;
}

}  // namespace roomgraph
