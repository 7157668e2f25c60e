#include "turn_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace roomgraph {
namespace {

constexpr double kOccupiedAbove = 0.65, kFreeBelow = 0.2;
constexpr double kRounding = 1e-6;  // [cells]; a quarter turn needs no more of them

Point middleOf(const GridFrame& frame) {
  return frame.origin + 0.5 * frame.resolution * Point{double(frame.width), double(frame.height)};
}

/** Exact for quarter turns. */
Point direction(double angle) {
  const double quarters = angle / (M_PI / 2), whole = std::round(quarters);
  if (std::abs(quarters - whole) > 1e-9) return {std::cos(angle), std::sin(angle)};
  constexpr std::array<Point, 4> axes{Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}};
  return axes[std::size_t((int(whole) % 4 + 4) % 4)];
}

/** Takes places of the turned map to the old one. */
class Unturn {
 public:
  Unturn(const MapPose& pose, const GridFrame& old)
      : middle_(middleOf(old)), axis_(direction(pose.angle)) {}

  Point operator()(Point p) const {
    const Point v = p - middle_;
    return middle_ + Point{dot(axis_, v), cross(axis_, v)};
  }

 private:
  Point middle_, axis_;
};

GridFrame turnedFrame(const GridFrame& old, const MapPose& pose) {
  const Point d = direction(pose.angle);
  const double c = std::abs(d.x), s = std::abs(d.y);
  GridFrame frame;
  frame.resolution = old.resolution / pose.finer;
  frame.width = int(std::ceil(pose.finer * (c * old.width + s * old.height) - kRounding));
  frame.height = int(std::ceil(pose.finer * (s * old.width + c * old.height) - kRounding));
  // With the corner kept, 2 x 2 cells become one, also where their number is odd.
  const Point size{double(frame.width), double(frame.height)};
  frame.origin = pose.angle == 0 ? old.origin : middleOf(old) - 0.5 * frame.resolution * size;
  return frame;
}

State commonestAtBorder(const Grid& grid) {
  std::array<std::size_t, 3> count{};
  const auto add = [&](int x, int y) { ++count[std::size_t(grid.at({x, y}))]; };
  for (int x = 0; x < grid.frame.width; ++x) add(x, 0), add(x, grid.frame.height - 1);
  for (int y = 0; y < grid.frame.height; ++y) add(0, y), add(grid.frame.width - 1, y);
  return State(std::max_element(count.begin(), count.end()) - count.begin());
}

/** A cell of side `size` of the turned map. */
State sampled(const Grid& grid, const Unturn& unturn, Point center, double size, State beyond) {
  std::array<int, 3> count{};
  for (int sample = 0; sample < 9; ++sample) {
    const int column = sample % 3 - 1, row = sample / 3 - 1;
    const Point shift{size / 3 * column, size / 3 * row};
    const Cell cell = grid.frame.cellAt(unturn(center + shift));
    const State state = grid.frame.contains(cell) ? grid.at(cell) : beyond;
    if (state == State::occupied) return state;
    ++count[std::size_t(state)];
  }
  return count[std::size_t(State::unknown)] > count[std::size_t(State::free)] ? State::unknown
                                                                              : State::free;
}

std::uint8_t greyOf(State state) {
  return state == State::occupied ? 0 : state == State::free ? 255 : 128;
}

}  // namespace

Point turnedBack(Point p, const MapPose& pose, const GridFrame& old) {
  return Unturn(pose, old)(p);
}

GreyMap turnMap(const Grid& grid, const MapPose& pose) {
  GreyMap map;
  map.frame = turnedFrame(grid.frame, pose);
  map.grey.resize(map.frame.cellCount());
  map.occupiedAbove = kOccupiedAbove;
  map.freeBelow = kFreeBelow;
  const State beyond = commonestAtBorder(grid);
  const Unturn unturn(pose, grid.frame);
  for (int y = 0; y < map.frame.height; ++y)
    for (int x = 0; x < map.frame.width; ++x) {
      const Point center = map.frame.center({x, y});
      map.grey[map.frame.index({x, y})] =
          greyOf(sampled(grid, unturn, center, map.frame.resolution, beyond));
    }
  return map;
}

}  // namespace roomgraph
