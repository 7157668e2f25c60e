#include "FloorPlan.h"

#include <algorithm>

namespace roomgraph {

FloorPlan::FloorPlan(int width, int height, double resolution, Point origin) {
  map_.frame.width = width;
  map_.frame.height = height;
  map_.frame.resolution = resolution;
  map_.frame.origin = origin;
  map_.grey.assign(map_.frame.cellCount(), grey::kUnknown);
  map_.occupiedAbove = 0.55;
  map_.freeBelow = 0.45;
  map_.source.kind = "gridmap";
}

void FloorPlan::fill(CellBox box, std::uint8_t level) {
  const GridFrame& frame = map_.frame;
  const int x0 = std::max(box.x0, 0), x1 = std::min(box.x1, frame.width);
  if (x0 >= x1) return;
  for (int y = std::max(box.y0, 0); y < std::min(box.y1, frame.height); ++y) {
    const auto row = map_.grey.begin() + std::ptrdiff_t(frame.index({0, y}));
    std::fill(row + x0, row + x1, level);
  }
}

void FloorPlan::putFurniture(CellBox box) {
  fill(box, grey::kWall);
  fill({box.x0 + 1, box.y0 + 1, box.x1 - 1, box.y1 - 1}, grey::kUnknown);
}

}  // namespace roomgraph
