#include "site_frame.h"

#include <algorithm>

#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {

GridFrame siteFrame(const Site& site) {
  Box box;
  double cell = kWallCell;
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    cell = std::max(cell, site.runs[i]->map.frame.resolution);
    for (const WallPoint& wall : site.runs[i]->map.walls) box.include(site.poses[i](wall.place));
  }
  if (box.isEmpty()) return {1, 1, cell, {}};
  return {int(box.size().x / cell) + 1, int(box.size().y / cell) + 1, cell, box.low};
}

bool isFreeIn(const WallMap& map, Point p) {
  const std::size_t cell = cellIndexAt(map.frame, p);
  return cell < map.states.size() && map.states[cell] == State::free;
}

}  // namespace roomgraph
