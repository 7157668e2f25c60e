#include "axis_deviation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/NearPlaces.h"
#include "roomgraph/geometry/principal_axis.h"

namespace roomgraph {
namespace {

constexpr double kDirectionReach = 1.5;  // of the walls that give a direction [m]
constexpr double kThickness = 0.25;      // of a wall, with its roughness [m]
constexpr double kMaxRoughness = 0.022;  // variance across over variance along
constexpr std::size_t kMinDirections = 100;

/** The direction in which the places lie [rad]; none where that is no line, or one that is shorter
 *  than their reach: such a line has a twelfth of its square as its variance. */
std::optional<double> directionOf(const PointSums& places) {
  const PrincipalAxis axis = principalAxis(places);
  if (axis.along < kDirectionReach * kDirectionReach / 12 ||
      axis.across > kMaxRoughness * axis.along)
    return std::nullopt;
  return axis.direction;
}

std::vector<Point> placesOf(const std::vector<WallPoint>& walls) {
  std::vector<Point> places;
  for (const WallPoint& wall : walls) places.push_back(wall.place);
  return places;
}

std::optional<double> directionAt(const std::vector<WallPoint>& walls, const NearPlaces& index,
                                  const WallPoint& wall) {
  PointSums near;
  index.forEachNear(wall.place, [&](std::uint32_t i) {
    const Point off = walls[i].place - wall.place;
    if (dot(walls[i].normal, wall.normal) >= kFacesAlike && norm(off) <= kDirectionReach &&
        std::abs(dot(off, wall.normal)) <= kThickness)
      near.add(off);
  });
  return directionOf(near);
}

}  // namespace

std::optional<double> axisDeviation(const std::vector<WallPoint>& walls) {
  const NearPlaces index(placesOf(walls), kDirectionReach);
  std::vector<double> directions;
  double cosine = 0, sine = 0;
  for (const WallPoint& wall : walls)
    if (const auto direction = directionAt(walls, index, wall)) {
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
