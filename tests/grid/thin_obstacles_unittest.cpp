#include "roomgraph/grid/thin_obstacles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_grid.h"

namespace roomgraph::test {
namespace {

std::size_t countKept(const std::vector<std::uint8_t>& flags) {
  return std::size_t(
      std::count_if(flags.begin(), flags.end(), [](auto flag) { return flag != 0; }));
}

TEST(ThinObstacles, dropsWhatBoundsNothing) {
  const Grid grid = gridFrom({".......", ".#####.", ".#####.", ".#####.", "......."});
  ThinObstaclesOptions options;
  options.neighbours = "none";
  EXPECT_EQ(countKept(thinObstacles(grid, options)), 15u);
  options.neighbours = "8";
  EXPECT_EQ(countKept(thinObstacles(grid, options)), 12u);
  options.neighbours = "4";
  EXPECT_EQ(countKept(thinObstacles(grid, options)), 12u);
}

TEST(ThinObstacles, fourNeighboursDropCornersThatEightKeep) {
  const Grid grid = gridFrom({"##.", "###", "###"});
  ThinObstaclesOptions options;
  options.neighbours = "8";
  const auto eight = thinObstacles(grid, options);
  EXPECT_TRUE(eight[grid.frame.index({1, 1})]);
  options.neighbours = "4";
  EXPECT_FALSE(thinObstacles(grid, options)[grid.frame.index({1, 1})]);
}

TEST(ThinObstacles, theBorderIsRepeatedOutwards) {
  const Grid grid = gridFrom({"##", "##"});
  EXPECT_EQ(countKept(thinObstacles(grid, {})), 0u);
}

TEST(ThinObstacles, unknownBoundsOnlyWhereAsked) {
  const Grid grid = gridFrom({".?.", ".?.", ".?."});
  ThinObstaclesOptions options;
  options.unknownIsObstacle = true;
  EXPECT_EQ(countKept(thinObstacles(grid, options)), 3u);
  options.unknownIsObstacle = false;
  EXPECT_EQ(countKept(thinObstacles(grid, options)), 0u);
}

}  // namespace
}  // namespace roomgraph::test
