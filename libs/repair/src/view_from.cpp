#include "roomgraph/repair/view_from.h"

#include <cmath>

#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {
namespace {

/** Whether nothing but free space lies between a place and a wall, but for what the wall itself and
 *  whatever the place lies in may take up. */
bool isInSight(const WallMap& map, Point from, Point wall) {
  const double length = distance(from, wall), step = map.frame.resolution / 2;
  const int steps = int(std::ceil((length - 2 * kSameWall) / step));
  for (int i = 0; i < steps; ++i) {
    const double along = kSameWall + i * step;
    const std::size_t cell = cellIndexAt(map.frame, from + (along / length) * (wall - from));
    if (cell >= map.states.size() || map.states[cell] != State::free) return false;
  }
  return true;
}

}  // namespace

LocalScan viewFrom(const WallMap& map, const Transform2D& pose, double range) {
  LocalScan view;
  const Point eye = pose.shift();
  const Motion2D back(pose.inverse());
  for (const WallPoint& wall : map.walls)
    if (squaredNorm(wall.place - eye) < range * range && dot(wall.normal, eye - wall.place) > 0 &&
        isInSight(map, eye, wall.place))
      view.walls.push_back({back(wall.place), back.turned(wall.normal)});
  return view;
}

}  // namespace roomgraph
