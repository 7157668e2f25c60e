#include "cut_strip.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace roomgraph {
namespace {

constexpr int kBisections = 20;
constexpr int kStep = 4;  // every so manyth cell is counted

struct Axis {
  Point direction;
  double middle = 0;
};

/** Places of the free cells, in the frame that `pose` leads to. */
std::vector<Point> freePlaces(const Grid& grid, const Transform2D& pose) {
  std::vector<Point> places;
  for (int y = 0; y < grid.frame.height; y += kStep)
    for (int x = 0; x < grid.frame.width; x += kStep)
      if (grid.at({x, y}) == State::free) places.push_back(pose(grid.frame.center({x, y})));
  return places;
}

/** Across which a strip is cut. */
Axis axisOf(const std::vector<Point>& places, bool isAlong) {
  Point mean;
  for (Point p : places) mean = mean + (1.0 / double(places.size())) * p;
  double xx = 0, xy = 0, yy = 0;
  for (Point p : places) {
    const Point d = p - mean;
    xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
  }
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy) + (isAlong ? M_PI_2 : 0);
  const Point direction{std::cos(angle), std::sin(angle)};
  std::vector<double> along;
  for (Point p : places) along.push_back(dot(p, direction));
  std::nth_element(along.begin(), along.begin() + std::ptrdiff_t(along.size() / 2), along.end());
  return {direction, along[along.size() / 2]};
}

template <class Keep>
Grid cut(Grid grid, const Transform2D& pose, Keep keep) {
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x)
      if (!keep(pose(grid.frame.center({x, y}))))
        grid.cells[grid.frame.index({x, y})] = State::unknown;
  return grid;
}

}  // namespace

CutPair cutStrip(const Grid& a, const Grid& b, const Transform2D& pose, const StripCut& how) {
  const std::vector<Point> freeA = freePlaces(a, {}), freeB = freePlaces(b, pose);
  std::vector<Point> common;
  for (Point p : freeB)
    if (a.isFree(p)) common.push_back(p);
  if (common.size() < 10) return {};
  const Axis axis = axisOf(common, how.isAlong);
  const auto along = [&](Point p) { return dot(p, axis.direction) - axis.middle; };
  const double areaA = a.frame.resolution * a.frame.resolution;
  const double areaB = b.frame.resolution * b.frame.resolution;
  const auto shareAt = [&](double half) {
    const auto count = [&](const std::vector<Point>& places, auto inside) {
      return double(std::count_if(places.begin(), places.end(), inside));
    };
    const double both = areaB * count(common, [&](Point p) { return std::abs(along(p)) <= half; });
    const double left = areaA * count(freeA, [&](Point p) { return along(p) <= half; });
    const double right = areaB * count(freeB, [&](Point p) { return along(p) >= -half; });
    return both / std::max(1e-9, std::min(left, right));
  };
  double low = 0, high = 200;
  if (shareAt(high) < how.share) return {};
  for (int i = 0; i < kBisections; ++i) {
    const double half = 0.5 * (low + high);
    (shareAt(half) < how.share ? low : high) = half;
  }
  CutPair pair;
  pair.a = cut(a, {}, [&](Point p) { return along(p) <= high; });
  pair.b = cut(b, pose, [&](Point p) { return along(p) >= -high; });
  const Transform2D back = pose.inverse();
  for (Point p : common)
    if (std::abs(along(p)) <= high) pair.places.push_back(back(p));
  return pair;
}

}  // namespace roomgraph
