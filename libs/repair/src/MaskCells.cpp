#include "MaskCells.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {
namespace {

/** What nav2's map server makes of a pixel: percents, or -1 for the unknown. */
int occupancy(const RosMapYaml& yaml, int grey) {
  if (yaml.mode == "raw") return grey <= 100 ? grey : -1;
  const double share = (yaml.negate ? grey : 255 - grey) / 255.0;
  if (share > yaml.occupiedAbove) return 100;
  if (share < yaml.freeBelow) return 0;
  if (yaml.mode == "trinary") return -1;
  return int(std::lround(99 * (share - yaml.freeBelow) / (yaml.occupiedAbove - yaml.freeBelow)));
}

}  // namespace

MaskGreys::MaskGreys(const RosMapYaml& yaml) {
  for (int grey = 0; grey < 256; ++grey)
    marks_[std::size_t(grey)] = std::max(0, occupancy(yaml, grey));
  if (yaml.negate || yaml.mode == "raw") free_ = 0;
}

std::vector<MaskRegion> maskRegions(const GridFrame& frame, const std::vector<bool>& isMarked) {
  UnionFind groups(frame.cellCount());
  const auto join = [&](std::size_t cell, Cell to) {
    if (frame.contains(to) && isMarked[frame.index(to)])
      groups.join(std::uint32_t(cell), std::uint32_t(frame.index(to)));
  };
  std::map<std::uint32_t, MaskRegion> regions;  // by their first cells
  for (Cell at{0, 0}; at.y < frame.height; ++at.y)
    for (at.x = 0; at.x < frame.width; ++at.x)
      if (const std::size_t cell = frame.index(at); isMarked[cell]) {
        join(cell, {at.x + 1, at.y});
        for (const int x : {-1, 0, 1}) join(cell, {at.x + x, at.y + 1});
      }
  for (std::size_t cell = 0; cell < isMarked.size(); ++cell)
    if (isMarked[cell]) regions[groups.find(std::uint32_t(cell))].push_back(cell);
  std::vector<MaskRegion> result;
  for (auto& [first, region] : regions) result.push_back(std::move(region));
  return result;
}

std::vector<Cell> cellsIn(const GridFrame& frame, const std::array<Point, 4>& corners) {
  Box box;
  Point sum;
  for (const Point corner : corners) box.include(corner), sum = sum + corner;
  const auto isInside = [&](Point p) {
    bool isLeft = false, isRight = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point along = corners[(i + 1) % 4] - corners[i];
      (cross(along, p - corners[i]) >= 0 ? isLeft : isRight) = true;
    }
    return !(isLeft && isRight);
  };
  std::vector<Cell> cells{frame.cellAt(0.25 * sum)};
  const Cell from = frame.cellAt(box.low), to = frame.cellAt(box.high);
  for (int y = from.y; y <= to.y; ++y)
    for (int x = from.x; x <= to.x; ++x)
      if (isInside(frame.center({x, y}))) cells.push_back({x, y});
  return cells;
}

}  // namespace roomgraph
