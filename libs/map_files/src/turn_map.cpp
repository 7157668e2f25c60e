#include "turn_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {
namespace {

/** A rotation about the origin of a frame, and its way back. */
struct Turn {
  double cosine = 1, sine = 0;

  Point operator()(Point p) const { return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y}; }
  Point back(Point p) const { return {cosine * p.x + sine * p.y, cosine * p.y - sine * p.x}; }
};

/** Exact for quarter turns, of which the yaw of a yaml is a rounded number. */
Turn turnOf(double yaw, const GridFrame& frame) {
  const double quarters = std::round(yaw / M_PI_2);
  const double farthest = std::hypot(double(frame.width), double(frame.height));  // [cells]
  if (std::abs(yaw - quarters * M_PI_2) * farthest >= 0.25) return {std::cos(yaw), std::sin(yaw)};
  constexpr std::array<Turn, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  return exact[std::size_t(int(quarters) % 4 + 4) % 4];
}

/** Around the turned map; where its corners meet cells, no cell is added for rounding. */
GridFrame frameOf(const GridFrame& from, const Turn& turn, const std::string& file) {
  const double w = from.width * from.resolution, h = from.height * from.resolution;
  Box box;
  for (const Point corner : {Point{}, Point{w, 0}, Point{0, h}, Point{w, h}})
    box.include(turn(corner));
  constexpr double rounding = 1e-6;
  const double columns = std::ceil(box.size().x / from.resolution - rounding);
  const double rows = std::ceil(box.size().y / from.resolution - rounding);
  if (columns * rows > double(kMostCells))
    refuse(file, "turned by its yaw it has more than 400 million cells", "crop it");
  GridFrame frame = from;
  frame.width = int(columns), frame.height = int(rows);
  frame.origin = from.origin + box.low;
  return frame;
}

}  // namespace

GreyMap turned(const GreyMap& map, double yaw, std::uint8_t outside, std::uint8_t darkest,
               const std::string& file) {
  const Turn turn = turnOf(yaw, map.frame);
  GreyMap out = map;
  out.frame = frameOf(map.frame, turn, file);
  out.grey.assign(out.frame.cellCount(), outside);
  const Point pivot = map.frame.origin;
  for (Cell c{0, 0}; c.y < out.frame.height; ++c.y)
    for (c.x = 0; c.x < out.frame.width; ++c.x) {
      const Cell from = map.frame.cellAt(pivot + turn.back(out.frame.center(c) - pivot));
      if (map.frame.contains(from)) out.grey[out.frame.index(c)] = map.grey[map.frame.index(from)];
    }
  for (Cell c{0, 0}; c.y < map.frame.height; ++c.y)
    for (c.x = 0; c.x < map.frame.width; ++c.x) {
      const std::uint8_t grey = map.grey[map.frame.index(c)];
      const Cell to = out.frame.cellAt(pivot + turn(map.frame.center(c) - pivot));
      if (grey > darkest || !out.frame.contains(to)) continue;
      std::uint8_t& there = out.grey[out.frame.index(to)];
      there = std::min(there, grey);
    }
  return out;
}

}  // namespace roomgraph
