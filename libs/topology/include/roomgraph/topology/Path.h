#pragma once
#include <vector>

#include "roomgraph/geometry/Polyline.h"

namespace roomgraph {

/** A drivable way between two vertices (paper II, "path"). */
struct Path {
  Polyline points;  ///< from the source to the target, both included
  /** For each segment of `points` an obstacle that is nearest to every place of it, so that the
   *  clearance is known everywhere. Empty for the straight paths inside of rooms. */
  std::vector<Point> obstacles;
  double length = 0;        ///< [m]
  double minClearance = 0;  ///< smallest distance to an obstacle [m]
};

/** A path along Voronoi edges; length and clearance are computed. */
[[nodiscard]] Path makePath(Polyline points, std::vector<Point> obstacles);

/** The place at `along` metres from the source; exactly the path's end at 0 and at its length. */
[[nodiscard]] Point placeOn(const Path& path, double along);

/** Distance to the nearest obstacle of a place on a path [m]; that of the whole path where the
 *  obstacles are not known. */
[[nodiscard]] double clearanceAt(const Path& path, double along);

/** The same way walked backwards (paper II, "twin"). */
[[nodiscard]] Path reversed(Path path);

/** First `a`, then `b`, which starts where `a` ends. */
[[nodiscard]] Path joined(Path a, const Path& b);

/** The piece between two distances from the start [m]; 0 <= from <= to <= length. Its clearance is
 *  that of the whole path where the obstacles are not known. */
[[nodiscard]] Path piece(const Path& path, double from, double to);

}  // namespace roomgraph
