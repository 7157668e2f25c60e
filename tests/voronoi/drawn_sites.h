#pragma once
#include "MapText.h"
#include "roomgraph/grid/obstacle_sites.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph::test {

inline ObstacleSites sitesOf(const MapText& map) {
  const Grid grid = gridOf(map);
  return obstacleSites(grid, thinObstacles(grid, {}), hasUnknown(map));
}

}  // namespace roomgraph::test
