#include "wall_distances.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "roomgraph/align/are_identical.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

bool isNothing(const Transform2D& pose) {
  constexpr double kTiny = 1e-6;
  return std::abs(pose.x) < kTiny && std::abs(pose.y) < kTiny && std::abs(pose.phi) < kTiny;
}

}  // namespace

void WallDistances::add(const WallDistances& other, double weight) {
  sum += weight * other.sum;
  count += weight * other.count;
  for (std::size_t i = 0; i < histogram.size(); ++i) histogram[i] += weight * other.histogram[i];
}

double WallDistances::quantile(double share) const {
  std::vector<WeightedValue> distances;
  for (std::size_t i = 0; i < histogram.size(); ++i)
    distances.push_back({double(i) * kStep, histogram[i]});
  return weightedQuantile(std::move(distances), share).value_or(0);
}

WallDistances wallDistances(const WallMap& map, const WallMap& other, const Transform2D& pose) {
  WallDistances result;
  // The table holds the wall that is nearest to the middle of a cell, which may be another one.
  const bool isItself = isNothing(pose) && areIdentical(map, other);
  for (const WallPoint& wall : map.walls) {
    const Point place = pose(wall.place), normal = turned(wall.normal, pose.phi);
    const std::size_t cell = cellIndexAt(other.frame, place);
    if (!hasSeen(other, cell)) continue;
    const WallPoint* found = isItself ? &wall : nearestWall(other, cell, normal);
    double apart = found ? distance(found->place, place) : WallMap::kReach;
    apart = isItself ? 0 : std::min(apart, WallMap::kReach);
    result.sum += apart;
    result.count += 1;
    result.histogram[std::size_t(std::lround(apart / WallDistances::kStep))] += 1;
  }
  return result;
}

}  // namespace roomgraph
