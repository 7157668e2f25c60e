#include "roomgraph/align/wall_quality.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "fitted_align.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/NearPlaces.h"
#include "roomgraph/geometry/principal_axis.h"

namespace roomgraph {
namespace {

bool isCopy(const WallPoint& wall, const WallPoint& other) {
  const Point off = other.place - wall.place;
  const double ahead = std::abs(dot(off, wall.normal));
  return ahead >= kSameWall && ahead <= fitted::kFarthestCopy &&
         std::abs(cross(wall.normal, off)) <= kWallNoise &&
         dot(wall.normal, other.normal) >= kFacesAlike;
}

/** The direction in which the places lie [rad]; none where that is no line, or one that is shorter
 *  than their reach: such a line has a twelfth of its square as its variance. */
std::optional<double> directionOf(const PointSums& places) {
  const PrincipalAxis axis = principalAxis(places);
  if (axis.along < fitted::kDirectionReach * fitted::kDirectionReach / 12 ||
      axis.across > fitted::kMaxRoughness * axis.along)
    return std::nullopt;
  return axis.direction;
}

std::optional<double> directionAt(const std::vector<WallPoint>& walls, const NearPlaces& index,
                                  const WallPoint& wall) {
  PointSums near;
  index.forEachNear(wall.place, [&](std::uint32_t i) {
    const Point off = walls[i].place - wall.place;
    if (dot(walls[i].normal, wall.normal) >= kFacesAlike && norm(off) <= fitted::kDirectionReach &&
        std::abs(dot(off, wall.normal)) <= fitted::kThickness)
      near.add(off);
  });
  return directionOf(near);
}

/** Steps along rows and columns to the nearest cell of that state, at most `most`. */
std::vector<std::uint8_t> stepsTo(State state, const Grid& grid, std::uint8_t most) {
  const int w = grid.frame.width, h = grid.frame.height;
  std::vector<std::uint8_t> steps(grid.frame.cellCount());
  const auto relax = [&](int x, int y, int fromX, int fromY) {
    if (fromX < 0 || fromY < 0 || fromX >= w || fromY >= h) return;
    std::uint8_t& mine = steps[grid.frame.index({x, y})];
    mine = std::min<std::uint8_t>(mine, std::uint8_t(steps[grid.frame.index({fromX, fromY})] + 1));
  };
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      steps[grid.frame.index({x, y})] = grid.at({x, y}) == state ? 0 : most;
      relax(x, y, x - 1, y), relax(x, y, x, y - 1);
    }
  for (int y = h; y-- > 0;)
    for (int x = w; x-- > 0;) relax(x, y, x + 1, y), relax(x, y, x, y + 1);
  return steps;
}

bool isFrayed(const Grid& grid, Cell c) {
  return grid.at(c) == State::free && grid.countBeside(c, State::free) < 4;
}

}  // namespace

bool hasCopy(const WallMap& map, const WallPoint& wall) {
  const auto isCopyAt = [&](double along) {
    const WallPoint* other = nearestWall(map, wall.place + along * wall.normal, wall.normal);
    return other && isCopy(wall, *other);
  };
  double along = kSameWall;
  while (along <= fitted::kFarthestCopy) {
    if (isCopyAt(along) || isCopyAt(-along)) return true;
    along += map.frame.resolution;
  }
  return false;
}

std::optional<double> wallDoubling(const WallMap& map) {
  if (map.walls.empty()) return std::nullopt;
  double doubled = 0;
  for (const WallPoint& wall : map.walls) doubled += hasCopy(map, wall);
  return doubled / double(map.walls.size());
}

std::vector<double> wallDirections(const std::vector<WallPoint>& walls) {
  const NearPlaces index(mapped(walls, &WallPoint::place), fitted::kDirectionReach);
  std::vector<double> directions;
  for (const WallPoint& wall : walls)
    if (const auto direction = directionAt(walls, index, wall)) directions.push_back(*direction);
  return directions;
}

std::optional<double> mainDirection(std::vector<double> directions) {
  for (double& direction : directions) direction = std::remainder(direction, M_PI / 2);
  std::sort(directions.begin(), directions.end());
  const std::size_t count = directions.size();
  for (std::size_t i = 0; i < count; ++i) directions.push_back(directions[i] + M_PI / 2);
  std::size_t most = 0, from = 0, end = 0;
  for (std::size_t i = 0; i < count; ++i) {
    while (end < i + count && directions[end] <= directions[i] + fitted::kAlike) ++end;
    if (end - i > most) most = end - i, from = i;
  }
  if (count == 0 || double(most) < fitted::kLeastShare * double(count)) return std::nullopt;
  const auto first = directions.begin() + std::ptrdiff_t(from);
  return std::accumulate(first, first + std::ptrdiff_t(most), 0.0) / double(most);
}

std::optional<double> axisDeviation(std::vector<double> directions) {
  if (directions.size() < fitted::kMinDirections) return std::nullopt;
  double cosine = 0, sine = 0;
  for (const double direction : directions)
    cosine += std::cos(4 * direction), sine += std::sin(4 * direction);  // all axes as one
  const double axis = std::atan2(sine, cosine) / 4;
  for (double& direction : directions)
    direction = std::abs(std::remainder(direction - axis, M_PI / 2));
  return median(std::move(directions));
}

std::optional<double> wallSharpness(const Grid& grid) {
  // What lies behind the face of a wall like ends of beams on one wall is wall as well.
  const int reach = std::clamp(int(std::lround(kSameSurface / grid.frame.resolution)), 1, 200);
  // Far from all walls the edge is where nobody looked on, and says nothing of them.
  const auto toFree = stepsTo(State::free, grid, std::uint8_t(reach + 1));
  const auto toWall = stepsTo(State::occupied, grid, std::uint8_t(reach + 1));
  double edge = 0, walls = 0;
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) {
      const std::size_t i = grid.frame.index({x, y});
      edge += toWall[i] <= reach && isFrayed(grid, {x, y});
      walls += grid.at({x, y}) == State::occupied && toFree[i] <= reach;
    }
  if (edge == 0 || walls == 0) return std::nullopt;
  return walls / edge;
}

}  // namespace roomgraph
