#pragma once
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** Of some wall points, how many lie where a map has looked, and how many of these on walls there:
 *  each counts by its distance to the nearest, half at `near`. */
struct WallShare {
  double all = 0, known = 0, found = 0;

  /** The share of the known points that was found; `doubt` more count as known, and not found. */
  double ofKnown(double doubt = 0) const { return known > 0 ? found / (known + doubt) : 0; }
};

/** Looks up every `stride`th of the points pointAt(0 to count - 1) where `pose` brings it. */
template <class PointAt>
WallShare wallShare(std::size_t count, const PointAt& pointAt, const WallMap& map,
                    const Transform2D& pose, double near = kWallNoise, std::size_t stride = 1) {
  const Motion2D forth(pose);
  WallShare share;
  for (std::size_t i = 0; i < count; i += stride, ++share.all) {
    const WallPoint& point = pointAt(i);
    const Point at = forth(point.place);
    const std::size_t cell = cellIndexAt(map.frame, at);
    if (!hasSeen(map, cell)) continue;
    ++share.known;
    if (const WallPoint* wall = nearestWall(map, cell, forth.turned(point.normal)))
      share.found += 1 / (1 + squaredNorm(wall->place - at) / (near * near));
  }
  return share;
}

}  // namespace roomgraph
