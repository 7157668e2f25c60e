#include "straight_ways.h"

#include "roomgraph/geometry/intersect.h"

namespace roomgraph {

Path straightPath(const ObstacleRows& obstacles, Point source, Point target, double clearance) {
  Path path;
  path.points = {source, target};
  path.length = distance(source, target);
  path.minClearance = obstacles.clearance(source, target, clearance);
  return path;
}

bool leavesRoom(const RoomIndex& index, Point from, Point to, double tolerance) {
  const double way = distance(from, to);
  for (const auto& [a, b] : index.openingsNear(from, to))
    for (const double at : intersect(from, to, a, b))
      if ((1 - at) * way > tolerance) return true;
  return false;
}

}  // namespace roomgraph
