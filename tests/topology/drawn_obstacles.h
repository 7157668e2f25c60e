#pragma once
#include "MapText.h"
#include "roomgraph/grid/obstacle_cells.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph::test {

inline ObstacleCells obstaclesOf(const MapText& map) {
  const Grid grid = gridOf(map);
  return obstacleCells(grid, thinObstacles(grid, {}), hasUnknown(map));
}

}  // namespace roomgraph::test
