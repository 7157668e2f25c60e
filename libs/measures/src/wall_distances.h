#pragma once
#include <array>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// Ours
// In:   two WallMap and how one lies in the other
// Out:  WallDistances
// Next: scoreRuns

/** How far the walls of one map lie from those of another. */
struct WallDistances {
  static constexpr double kStep = 0.005;  ///< of the histogram [m]
  double sum = 0;  ///< of the distances, each at most WallMap::kReach: also where there is none [m]
  double count = 0;  ///< wall points
  /** Points by distance, rounded to kStep. */
  std::array<double, std::size_t(WallMap::kReach / kStep) + 1> histogram{};

  /** none for no points: 0. */
  double mean() const { return count > 0 ? sum / count : 0; }
  /** Counts `other` in, `weight` times. */
  void add(const WallDistances& other, double weight = 1);
  /** The distance that a share of the points does not exceed, to half a kStep; 0 without points. */
  double quantile(double share) const;
};

/** For each wall point of `map` that lies where `other` has seen free space or wall: the distance
 *  to the nearest wall of `other` that faces about the same way (within 45 degrees, see
 *  nearestWall). `pose` is other <- map. A map against itself gives zeros. O(points). */
WallDistances wallDistances(const WallMap& map, const WallMap& other, const Transform2D& pose);

}  // namespace roomgraph
