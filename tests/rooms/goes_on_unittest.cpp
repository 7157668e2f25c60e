#include "goes_on.h"

#include <gtest/gtest.h>

#include "MapText.h"

namespace roomgraph::test {
namespace {

const std::vector<std::string> kWall = {"...........", "####...####", "..........."};
const std::vector<std::string> kStubs = {"...........", "...#...#...", "..........."};
const std::vector<std::string> kUnknown = {"...........", "???#...#???", "..........."};
const std::vector<std::string> kRagged = {"..#.....#..", "##?#...#?##", "..........."};
const std::vector<std::string> kBlock = {"####...####", "####...####", "####...####",
                                         "####...####", "####...####", "####...####"};

/** Beyond the right end of the opening. */
bool goesOnIn(const std::vector<std::string>& rows, bool (*test)(const Grid&, Point, Point)) {
  const Grid grid = gridOf(drawn(rows, 1));
  const int y = grid.frame.height / 2;
  return test(grid, grid.frame.center({7, y}), grid.frame.center({3, y}));
}

TEST(GoesOn, whatNobodyHasSeenMayBeWall) {
  EXPECT_TRUE(goesOnIn(kWall, goesOn));
  EXPECT_TRUE(goesOnIn(kUnknown, goesOn));
  EXPECT_FALSE(goesOnIn(kStubs, goesOn));
}

TEST(WallGoesOn, mostOfItIsSeenToBeWall) {
  EXPECT_TRUE(goesOnIn(kWall, wallGoesOn));
  EXPECT_TRUE(goesOnIn(kRagged, wallGoesOn));
  EXPECT_FALSE(goesOnIn(kUnknown, wallGoesOn));
  EXPECT_FALSE(goesOnIn(kStubs, wallGoesOn));
}

TEST(WallGoesOn, aWallIsThinnerThanTheOpeningIsWide) {
  EXPECT_TRUE(goesOnIn(kBlock, goesOn));
  EXPECT_FALSE(goesOnIn(kBlock, wallGoesOn));
}

}  // namespace
}  // namespace roomgraph::test
