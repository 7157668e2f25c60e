#include "site_frame.h"

#include <algorithm>

#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {

GridFrame siteFrame(const Site& site) {
  Point low{1e30, 1e30}, high{-1e30, -1e30};
  double cell = 0.1;
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    cell = std::max(cell, site.runs[i]->map.frame.resolution);
    for (const WallPoint& wall : site.runs[i]->map.walls) {
      const Point p = site.poses[i](wall.place);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  if (low.x > high.x) return {1, 1, cell, {}};
  return {int((high.x - low.x) / cell) + 1, int((high.y - low.y) / cell) + 1, cell, low};
}

bool isFreeIn(const WallMap& map, Point p) {
  const std::size_t cell = cellIndexAt(map.frame, p);
  return cell < map.states.size() && map.states[cell] == State::free;
}

}  // namespace roomgraph
