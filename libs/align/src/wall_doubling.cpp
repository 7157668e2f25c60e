#include "roomgraph/align/wall_doubling.h"

#include <cmath>

#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {
namespace {

constexpr double kFarthestCopy = 0.8;  // from one copy to the other [m]

bool isCopy(const WallPoint& wall, const WallPoint& other) {
  const Point off = other.place - wall.place;
  const double ahead = std::abs(dot(off, wall.normal));
  return ahead >= kSameWall && ahead <= kFarthestCopy &&
         std::abs(cross(wall.normal, off)) <= kWallNoise &&
         dot(wall.normal, other.normal) >= kFacesAlike;
}

}  // namespace

bool hasCopy(const WallMap& map, const WallPoint& wall) {
  const auto isCopyAt = [&](double along) {
    const std::size_t cell = cellIndexAt(map.frame, wall.place + along * wall.normal);
    const WallPoint* other = nearestWall(map, cell, wall.normal);
    return other && isCopy(wall, *other);
  };
  double along = kSameWall;
  while (along <= kFarthestCopy) {
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

}  // namespace roomgraph
