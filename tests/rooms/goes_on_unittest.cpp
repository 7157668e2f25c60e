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

const std::vector<std::string> kOneSided = {"...........", "...#...####", "..........."};

/** Of the opening, beyond its right end. */
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

TEST(IsInWall, mostOfItIsSeenToBeWall) {
  EXPECT_TRUE(goesOnIn(kWall, isInWall));
  EXPECT_TRUE(goesOnIn(kRagged, isInWall));
  EXPECT_FALSE(goesOnIn(kUnknown, isInWall));
  EXPECT_FALSE(goesOnIn(kStubs, isInWall));
}

TEST(IsInWall, itGoesOnAtBothEnds) {
  EXPECT_TRUE(goesOnIn(kOneSided, goesOn));
  EXPECT_FALSE(goesOnIn(kOneSided, isInWall));
}

TEST(IsInWall, aWallIsThinnerThanTheOpeningIsWide) {
  EXPECT_TRUE(goesOnIn(kBlock, goesOn));
  EXPECT_FALSE(goesOnIn(kBlock, isInWall));
}

}  // namespace
}  // namespace roomgraph::test
