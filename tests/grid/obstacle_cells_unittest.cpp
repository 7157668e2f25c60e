#include "roomgraph/grid/obstacle_cells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_grid.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph::test {
namespace {

TEST(ObstacleCells, areOrderedByRowThenColumn) {
  const Grid grid = gridFrom({"#.#", "...", "##."});
  ThinObstaclesOptions all;
  all.neighbours = "none";
  for (const bool withRing : {false, true}) {
    const ObstacleCells obstacles = obstacleCells(grid, thinObstacles(grid, all), withRing);
    EXPECT_TRUE(std::is_sorted(obstacles.cells.begin(), obstacles.cells.end(), [](Cell a, Cell b) {
      return a.y < b.y || (a.y == b.y && a.x < b.x);
    }));
    EXPECT_EQ(obstacles.cells.size() > 4, withRing);
  }
}

TEST(ObstacleCells, theRingStandsBesideFreeCellsOnly) {
  const Grid grid = gridFrom({"#####", "#####", "####."});
  const auto none = std::vector<std::uint8_t>(grid.cells.size(), 0);
  const ObstacleCells obstacles = obstacleCells(grid, none, true);
  // Below, beside and diagonally round the free cell in the corner.
  EXPECT_EQ(obstacles.cells.size(), 5u);
  EXPECT_TRUE(obstacleCells(grid, none, false).cells.empty());
}

}  // namespace
}  // namespace roomgraph::test
