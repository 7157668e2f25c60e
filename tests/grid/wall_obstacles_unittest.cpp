#include "roomgraph/grid/wall_obstacles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_grid.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph::test {
namespace {

/** How many obstacles are no wall. */
std::ptrdiff_t unseenObstacles(const Grid& grid) {
  const auto isWall = wallObstacles(grid, obstacleCells(grid, thinObstacles(grid, {}), true));
  return std::count(isWall.begin(), isWall.end(), 0);
}

TEST(WallObstacles, onADrawingUnknownIsAsGoodAsWall) {
  EXPECT_EQ(unseenObstacles(gridFrom({"????????", "?......?", "?......?", "?......?", "?......?",
                                      "?......?", "?......?", "????????"})),
            0);
}

TEST(WallObstacles, whereABeamIsTheEdgeOfTheUnknownIsNoWall) {
  const Grid grid = gridFrom({"????????????", "?......?????", "?......?????", "?......?????",
                              "?...........", "?......?????", "?......?????", "????????????"});
  EXPECT_GT(unseenObstacles(grid), 20);
}

TEST(WallObstacles, aRimOfUnknownCellsHidesNoWall) {
  const Grid grid = gridFrom({"############????", "#??????????#????", "#?........?#????",
                              "#?........?#????", "#?........?#????", "#?..............",
                              "#?........?#????", "#??????????#????", "############????"});
  const auto obstacles = obstacleCells(grid, thinObstacles(grid, {}), true);
  const auto isWall = wallObstacles(grid, obstacles);
  for (std::size_t i = 0; i < isWall.size(); ++i)
    if (obstacles.cells[i].x < 10) {
      EXPECT_TRUE(isWall[i]) << obstacles.cells[i].x;
    }
  EXPECT_GT(std::count(isWall.begin(), isWall.end(), 0), 0);
}

}  // namespace
}  // namespace roomgraph::test
