#include "roomgraph/grid/wall_sites.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_grid.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph::test {
namespace {

/** How many sites are no wall. */
std::ptrdiff_t unseenSites(const Grid& grid) {
  const auto isWall = wallSites(grid, obstacleSites(grid, thinObstacles(grid, {}), true));
  return std::count(isWall.begin(), isWall.end(), 0);
}

TEST(WallSites, onADrawingUnknownIsAsGoodAsWall) {
  EXPECT_EQ(unseenSites(gridFrom({"????????", "?......?", "?......?", "?......?", "?......?",
                                  "?......?", "?......?", "????????"})),
            0);
}

TEST(WallSites, whereABeamIsTheEdgeOfTheUnknownIsNoWall) {
  const Grid grid = gridFrom({"????????????", "?......?????", "?......?????", "?......?????",
                              "?...........", "?......?????", "?......?????", "????????????"});
  EXPECT_GT(unseenSites(grid), 20);
}

TEST(WallSites, aRimOfUnknownCellsHidesNoWall) {
  const Grid grid = gridFrom({"############????", "#??????????#????", "#?........?#????",
                              "#?........?#????", "#?........?#????", "#?..............",
                              "#?........?#????", "#??????????#????", "############????"});
  const auto sites = obstacleSites(grid, thinObstacles(grid, {}), true);
  const auto isWall = wallSites(grid, sites);
  for (std::size_t i = 0; i < isWall.size(); ++i)
    if (sites.cells[i].x < 10) {
      EXPECT_TRUE(isWall[i]) << sites.cells[i].x;
    }
  EXPECT_GT(std::count(isWall.begin(), isWall.end(), 0), 0);
}

}  // namespace
}  // namespace roomgraph::test
