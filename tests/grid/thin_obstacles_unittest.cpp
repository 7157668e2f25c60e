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

/** What stays, cell by cell, the border repeated outwards. */
bool isKept(const Grid& grid, int x, int y, const ThinObstaclesOptions& options) {
  const auto isObstacle = [&](int dx, int dy) {
    const State state = grid.at({std::clamp(x + dx, 0, grid.frame.width - 1),
                                 std::clamp(y + dy, 0, grid.frame.height - 1)});
    return state == State::occupied || (options.unknownIsObstacle && state == State::unknown);
  };
  bool isEnclosed = options.neighbours != "none";
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (options.neighbours == "8" || dx == 0 || dy == 0)
        isEnclosed = isEnclosed && isObstacle(dx, dy);
  return isObstacle(0, 0) && !isEnclosed;
}

TEST(ThinObstacles, eachCellStaysByItsOwnNeighbours) {
  const Grid grid = gridFrom({"###?.##?###", "####?######", "##.########", "#####?##?##",
                              "###########", "?##?#######", "???########"});
  for (const char* neighbours : {"none", "4", "8"})
    for (const bool unknownIsObstacle : {false, true}) {
      ThinObstaclesOptions options;
      options.neighbours = neighbours;
      options.unknownIsObstacle = unknownIsObstacle;
      const auto kept = thinObstacles(grid, options);
      for (int y = 0; y < grid.frame.height; ++y)
        for (int x = 0; x < grid.frame.width; ++x)
          EXPECT_EQ(kept[grid.frame.index({x, y})] != 0, isKept(grid, x, y, options))
              << neighbours << " at " << x << ", " << y;
    }
}

}  // namespace
}  // namespace roomgraph::test
