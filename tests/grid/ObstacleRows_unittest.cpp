#include "roomgraph/grid/ObstacleRows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_grid.h"
#include "roomgraph/geometry/Polyline.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph::test {
namespace {

TEST(ObstacleRows, findTheNearestCellAsBruteForceDoes) {
  Grid grid = gridFrom(std::vector<std::string>(20, std::string(30, '.')), 0.1);
  std::uint32_t state = 7;
  const auto random = [&](std::uint32_t n) {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % n;
  };
  for (int i = 0; i < 25; ++i) grid.cells[random(600)] = State::occupied;
  ThinObstaclesOptions all;
  all.neighbours = "none";
  const ObstacleCells obstacles = obstacleCells(grid, thinObstacles(grid, all), true);
  const ObstacleRows rows(obstacles);
  for (int i = 0; i < 500; ++i) {
    const Point a{0.8 + 0.01 * random(350), 1.8 + 0.01 * random(250)};
    const Point b = i % 3 == 0 ? a : a + Point{0.01 * random(150) - 0.7, 0.01 * random(150) - 0.7};
    const double limit = 0.05 + 0.01 * random(100);
    double nearest = limit;
    for (const Cell cell : obstacles.cells)
      nearest = std::min(nearest, distanceToSegment(obstacles.frame.center(cell), a, b));
    EXPECT_DOUBLE_EQ(rows.clearance(a, b, limit), nearest) << i;
    EXPECT_EQ(rows.isClear(a, b, limit), nearest == limit) << i;
  }
}

TEST(ObstacleRows, mayBeAskedFarBeyondTheMap) {
  const ObstacleCells obstacles{{5, 5, 0.1, {}}, {{0, 0}}};
  EXPECT_NEAR(ObstacleRows(obstacles).clearance({0.45, 0.05}, {0.45, 0.05}, 100), 0.4, 1e-9);
}

TEST(ObstacleRows, withoutSitesGiveTheLimit) {
  const ObstacleCells obstacles{{5, 5, 0.1, {}}, {}};
  EXPECT_EQ(ObstacleRows(obstacles).clearance({0.1, 0.1}, {0.4, 0.3}, 2.5), 2.5);
}

}  // namespace
}  // namespace roomgraph::test
