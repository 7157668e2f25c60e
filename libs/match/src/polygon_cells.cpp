#include "roomgraph/match/polygon_cells.h"

#include <algorithm>
#include <cmath>

namespace roomgraph {
namespace {

/** Where row `y` of the cell centres enters and leaves the polygon. */
std::vector<double> crossings(const Polygon& polygon, double y) {
  std::vector<double> xs;
  const auto addRing = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if ((a.y <= y) != (b.y <= y)) xs.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  };
  addRing(polygon.outer);
  for (const Ring& hole : polygon.holes) addRing(hole);
  std::sort(xs.begin(), xs.end());
  return xs;
}

}  // namespace

std::vector<Cell> cellsIn(const Polygon& polygon, const GridFrame& frame) {
  std::vector<Cell> cells;
  if (polygon.outer.empty()) return cells;
  const Box box = boundingBox(polygon.outer);
  const int low = std::max(0, frame.cellAt(box.low).y);
  const int high = std::min(frame.height - 1, frame.cellAt(box.high).y);
  const auto column = [&](double x) {  // the first whose centre is not left of x
    const double c = std::ceil((x - frame.origin.x) / frame.resolution - 0.5);
    return int(std::clamp(c, 0.0, double(frame.width)));
  };
  for (int y = low; y <= high; ++y) {
    const std::vector<double> xs = crossings(polygon, frame.center({0, y}).y);
    for (std::size_t k = 0; k + 1 < xs.size(); k += 2)
      for (int x = column(xs[k]); x < column(xs[k + 1]); ++x) cells.push_back({x, y});
  }
  return cells;
}

}  // namespace roomgraph
