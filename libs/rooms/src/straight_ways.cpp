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
  const Box box = boundingBox({from, to});
  const auto isBeside = [&](Point a, Point b) {
    return std::max(a.x, b.x) < box.low.x || std::min(a.x, b.x) > box.high.x ||
           std::max(a.y, b.y) < box.low.y || std::min(a.y, b.y) > box.high.y;
  };
  const auto isCrossedBefore = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      if (isBeside(a, b)) continue;
      for (const double at : intersect(from, to, a, b))
        if ((1 - at) * way > tolerance) return true;
    }
    return false;
  };
  return isCrossedBefore(polygon.outer) ||
         std::any_of(polygon.holes.begin(), polygon.holes.end(), isCrossedBefore);
}

}  // namespace roomgraph
