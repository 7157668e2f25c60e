#include "roomgraph/grid/GridFrame.h"

#include <cmath>

namespace roomgraph {
namespace {

// Clamped to just outside of the grid: an int cannot hold every double.
int cellIndex(double offset, double resolution, int count) {
  const double index = offset / resolution;
  if (!(index >= 0)) return -1;
  return index < count ? int(index) : count;
}

}  // namespace

Cell GridFrame::cellAt(Point p) const {
  return {cellIndex(p.x - origin.x, resolution, width),
          cellIndex(p.y - origin.y, resolution, height)};
}

bool GridFrame::isSane() const {
  return resolution >= kSmallestCell && resolution <= kLargestCell &&
         std::abs(origin.x) <= kFarthestOrigin && std::abs(origin.y) <= kFarthestOrigin;
}

}  // namespace roomgraph
