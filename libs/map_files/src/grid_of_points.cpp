#include "grid_of_points.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {
namespace {

using mrpt::math::TPoint3Df;

constexpr double kMargin = 0.5;  // around all points [m]
constexpr std::uint8_t kWallGrey = 0, kFreeGrey = 255;

GridFrame frameOf(const std::vector<TPoint3Df>& points, double resolution,
                  const std::string& file) {
  Box box;
  for (const TPoint3Df& p : points) box.include({double(p.x), double(p.y)});
  const auto first = [&](double value) { return std::floor((value - kMargin) / resolution); };
  const auto last = [&](double value) { return std::ceil((value + kMargin) / resolution); };
  const double width = last(box.high.x) - first(box.low.x),
               height = last(box.high.y) - first(box.low.y);
  if (!(width * height <= double(kMostCells)))
    refuse(file, "its points reach over more than 400 million cells", "use a coarser resolution");
  GridFrame frame;
  frame.width = int(width), frame.height = int(height), frame.resolution = resolution;
  frame.origin = {first(box.low.x) * resolution, first(box.low.y) * resolution};
  return frame;
}

/** Fills gaps of up to `most` cells between free ones, along rows (step 1) or columns. */
void fillGaps(std::vector<std::uint8_t>& grey, const GridFrame& frame, int most, bool isAlongRows) {
  const int lines = isAlongRows ? frame.height : frame.width;
  const int length = isAlongRows ? frame.width : frame.height;
  for (int line = 0; line < lines; ++line) {
    const auto at = [&](int i) -> std::uint8_t& {
      return grey[frame.index(isAlongRows ? Cell{i, line} : Cell{line, i})];
    };
    int previous = -1;
    for (int i = 0; i < length; ++i) {
      if (at(i) == kWallGrey) previous = -1;
      if (at(i) != kFreeGrey) continue;
      if (previous >= 0 && i - previous - 1 <= most)
        for (int k = previous + 1; k < i; ++k) at(k) = kFreeGrey;
      previous = i;
    }
  }
}

}  // namespace

GreyMap gridOfPoints(const std::vector<TPoint3Df>& points, const Slice& slice, double resolution,
                     const std::string& file) {
  GreyMap map;
  map.frame = frameOf(points, resolution, file);
  map.grey.assign(map.frame.cellCount(), 128);  // nobody has seen them
  const auto cellOf = [&](const TPoint3Df& p) -> std::uint8_t& {
    return map.grey[map.frame.index(map.frame.cellAt({double(p.x), double(p.y)}))];
  };
  for (const TPoint3Df& p : points)
    if (std::abs(double(p.z) - slice.floor) <= 0.15) cellOf(p) = kFreeGrey;
  for (const TPoint3Df& p : points)
    if (slice.contains(double(p.z))) cellOf(p) = kWallGrey;
  const int gap = int(0.3 / resolution);
  fillGaps(map.grey, map.frame, gap, true);
  fillGaps(map.grey, map.frame, gap, false);
  map.occupiedAbove = 0.55;
  map.freeBelow = 0.45;
  return map;
}

}  // namespace roomgraph
