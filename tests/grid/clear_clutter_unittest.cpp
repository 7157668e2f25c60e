#include "roomgraph/grid/clear_clutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_grid.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph::test {
namespace {

ClearedMap cleared(const Grid& grid, double maxSize) {
  ClearClutterOptions options;
  options.maxSize = maxSize;
  return clearClutter(grid, obstacleSites(grid, thinObstacles(grid, {}), false), options);
}

TEST(ClearClutter, aLimitOfZeroKeepsEvenSingleCells) {
  const Grid grid = gridFrom({".....", ".....", "..#..", ".....", "....."});
  EXPECT_TRUE(cleared(grid, 0).clutter.empty());
  EXPECT_EQ(cleared(grid, 0.15).clutter.size(), 1u) << "the diagonal of a cell is 0.141 m";
}

TEST(ClearClutter, freesATableAndTellsOfIt) {
  const Grid grid =
      gridFrom({"########", "#......#", "#.##...#", "#.##...#", "#......#", "########"});
  const ClearedMap map = cleared(grid, 0.5);
  ASSERT_EQ(map.clutter.size(), 1u);
  EXPECT_NEAR(distance(map.clutter[0].center, {1.3, 2.3}), 0, 1e-12) << "metres, map frame";
  EXPECT_NEAR(map.clutter[0].size, 0.2 * std::sqrt(2), 1e-12);
  EXPECT_EQ(std::count(map.isClutter.begin(), map.isClutter.end(), 1), 4) << "of the sites";
  EXPECT_EQ(std::count(map.grid.cells.begin(), map.grid.cells.end(), State::free), 24);
}

TEST(ClearClutter, aSpeckThatBeamsMissedIsFreedButNoClutter) {
  const Grid grid = gridFrom({"#######", "#.....#", "#.??..#", "#.....#", "#######"});
  const ClearedMap map = cleared(grid, 0.5);
  EXPECT_TRUE(map.clutter.empty());
  EXPECT_EQ(std::count(map.grid.cells.begin(), map.grid.cells.end(), State::free), 15);
}

TEST(ClearClutter, aBoxOfUnseenInsideIsClutter) {
  const Grid grid = gridFrom({".......", ".#####.", ".#???#.", ".#???#.", ".#####.", "......."});
  EXPECT_EQ(cleared(grid, 1).clutter.size(), 1u);
}

TEST(ClearClutter, whatTouchesAWallIsAPartOfIt) {
  const Grid grid = gridFrom({"######", "#....#", "#.#..#", "##...#", "######"});
  EXPECT_TRUE(cleared(grid, 0.3).clutter.empty());
}

TEST(ClearClutter, whatReachesTheBorderOrIsTooLargeStays) {
  EXPECT_TRUE(cleared(gridFrom({"....", ".#..", ".#.."}), 1).clutter.empty());
  const Grid wall = gridFrom({".......", ".#####.", "......."});
  EXPECT_TRUE(cleared(wall, 0.5).clutter.empty());
  EXPECT_EQ(cleared(wall, 0.52).clutter.size(), 1u);
}

TEST(ClearClutter, unknownCellsBelongToTheObstacle) {
  // A table whose inside no scan has seen.
  const Grid grid = gridFrom({".....", ".###.", ".#?#.", ".###.", "....."});
  const ClearedMap map = cleared(grid, 0.5);
  ASSERT_EQ(map.clutter.size(), 1u);
  EXPECT_EQ(std::count(map.grid.cells.begin(), map.grid.cells.end(), State::unknown), 0);
}

}  // namespace
}  // namespace roomgraph::test
