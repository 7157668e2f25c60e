#include "map_metrics.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/PointSums.h"

namespace roomgraph {
namespace {

/** The points, by squares of the plane. */
class Squares {
 public:
  Squares(const std::vector<Point>& points, double side) : side_(side) {
    for (const Point p : points) points_[squareOf(p)].push_back(p);
  }

  PointSums around(Point at, double radius) const {
    PointSums sums;
    const auto [x, y] = squareOf(at);
    for (std::int64_t i = x - 1; i <= x + 1; ++i)
      for (std::int64_t j = y - 1; j <= y + 1; ++j) {
        const auto square = points_.find({i, j});
        if (square == points_.end()) continue;
        for (const Point p : square->second)
          if (distance(p, at) <= radius) sums.add(p - at);
      }
    return sums;
  }

 private:
  std::pair<std::int64_t, std::int64_t> squareOf(Point p) const {
    return {std::int64_t(std::floor(p.x / side_)), std::int64_t(std::floor(p.y / side_))};
  }

  double side_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Point>> points_;
};

/** What lies round a point: the eigenvalues of its covariance, and which way the wall runs. */
struct Surroundings {
  double large = 0, small = 0;  // [m2]
  double direction = 0;         // [rad]

  explicit Surroundings(const PointSums& s) {
    const double mx = s.x / s.count, my = s.y / s.count, n = s.count - 1;
    const double xx = (s.xx - s.count * mx * mx) / n, yy = (s.yy - s.count * my * my) / n;
    const double xy = (s.xy - s.count * mx * my) / n;
    const double middle = (xx + yy) / 2, spread = std::hypot((xx - yy) / 2, xy);
    large = middle + spread, small = middle - spread;
    direction = std::atan2(2 * xy, xx - yy) / 2;
  }
};

/** The direction that most walls run along, or at right angles to. */
double mainDirection(const std::vector<Surroundings>& all) {
  double cosines = 0, sines = 0;
  for (const Surroundings& s : all) {
    cosines += (s.large - s.small) * std::cos(4 * s.direction);
    sines += (s.large - s.small) * std::sin(4 * s.direction);
  }
  return std::atan2(sines, cosines) / 4;
}

double orthogonalOf(const std::vector<Surroundings>& all, const MapMetricsOptions& options) {
  const double main = mainDirection(all);
  std::array<std::vector<double>, 2> along;
  for (const Surroundings& s : all) {
    if (s.small > options.maxWidth * s.large) continue;
    const double off = s.direction - main, quarter = std::round(off / (M_PI / 2));
    if (std::abs(off - quarter * M_PI / 2) > options.maxDeviation) continue;
    along[std::size_t(std::abs(std::lround(quarter))) % 2].push_back(s.small);
  }
  double sum = 0;
  for (const std::vector<double>& one : along) sum += one.empty() ? 0 : median(one);
  return sum;
}

}  // namespace

MapMetrics mapMetrics(const std::vector<Point>& points, const MapMetricsOptions& options) {
  const Squares squares(points, options.radius);
  std::vector<Surroundings> all;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / options.samples);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const PointSums sums = squares.around(points[i], options.radius);
    if (std::size_t(sums.count) < options.minPoints) continue;
    const Surroundings found(sums);
    if (found.small > 0) all.push_back(found);
  }
  MapMetrics metrics;
  if (all.empty()) return metrics;
  for (const Surroundings& s : all) {
    metrics.entropy += std::log(2 * M_PI * M_E * std::sqrt(s.large * s.small)) / double(all.size());
    metrics.variance += s.small / double(all.size());
  }
  metrics.orthogonal = orthogonalOf(all, options);
  return metrics;
}

}  // namespace roomgraph
