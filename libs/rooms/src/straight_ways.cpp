#include "straight_ways.h"

#include <algorithm>

#include "roomgraph/geometry/intersect.h"

namespace roomgraph {

Path straightPath(const ObstacleRows& obstacles, Point source, Point target, double clearance) {
  Path path;
  path.points = {source, target};
  path.length = distance(source, target);
  path.minClearance = obstacles.clearance(source, target, clearance);
  return path;
}

bool leavesPolygon(const Polygon& polygon, Point from, Point to, double tolerance) {
  const double way = distance(from, to);
  const auto isCrossedBefore = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (const double at : intersect(from, to, ring[i], ring[(i + 1) % ring.size()]))
        if ((1 - at) * way > tolerance) return true;
    return false;
  };
  return isCrossedBefore(polygon.outer) ||
         std::any_of(polygon.holes.begin(), polygon.holes.end(), isCrossedBefore);
}

}  // namespace roomgraph
