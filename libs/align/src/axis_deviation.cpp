#include "axis_deviation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/principal_axis.h"

namespace roomgraph {
namespace {

constexpr double kDirectionReach = 1.5;  // of the walls that give a direction [m]
constexpr double kThickness = 0.25;      // of a wall, with its roughness [m]
constexpr double kSameWallFacing = 0.7;  // cosine between the normals of one wall
constexpr double kMinLength = 0.42;      // of a straight piece, as a standard deviation [m]
constexpr double kMaxRoughness = 0.022;  // variance across over variance along
constexpr std::size_t kMinNear = 8, kMinDirections = 100;

/** The direction in which the places lie [rad]; none where that is no line. */
std::optional<double> directionOf(const PointSums& places) {
  if (places.count < double(kMinNear)) return std::nullopt;
  const PrincipalAxis axis = principalAxis(places);
  if (axis.along < kMinLength * kMinLength || axis.across > kMaxRoughness * axis.along)
    return std::nullopt;
  return axis.direction;
}

using Squares = std::map<std::pair<int, int>, std::vector<const WallPoint*>>;

std::pair<int, int> squareOf(Point p) {
  return {int(std::floor(p.x / kDirectionReach)), int(std::floor(p.y / kDirectionReach))};
}

std::optional<double> directionAt(const Squares& squares, const WallPoint& wall) {
  PointSums near;
  const auto [x0, y0] = squareOf(wall.place);
  for (int x = x0 - 1; x <= x0 + 1; ++x)
    for (int y = y0 - 1; y <= y0 + 1; ++y) {
      const auto it = squares.find({x, y});
      if (it == squares.end()) continue;
      for (const WallPoint* other : it->second) {
        const Point off = other->place - wall.place;
        if (dot(other->normal, wall.normal) >= kSameWallFacing && norm(off) <= kDirectionReach &&
            std::abs(dot(off, wall.normal)) <= kThickness)
          near.add(off);
      }
    }
  return directionOf(near);
}

}  // namespace

std::optional<double> axisDeviation(const std::vector<WallPoint>& walls) {
  Squares squares;
  for (const WallPoint& wall : walls) squares[squareOf(wall.place)].push_back(&wall);
  std::vector<double> directions;
  double cosine = 0, sine = 0;
  for (const WallPoint& wall : walls)
    if (const auto direction = directionAt(squares, wall)) {
      directions.push_back(*direction);
      cosine += std::cos(4 * *direction), sine += std::sin(4 * *direction);  // all axes as one
    }
  if (directions.size() < kMinDirections) return std::nullopt;
  const double axis = std::atan2(sine, cosine) / 4;
  for (double& direction : directions)
    direction = std::abs(std::remainder(direction - axis, M_PI / 2));
  return median(std::move(directions));
}

}  // namespace roomgraph
