#include "goes_on.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

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

TEST(IsInRoughWall, theWallMayLeaveTheLineByACell) {
  const std::vector<std::string> turned = {".......####", "####...#...", "..........."};
  const std::vector<std::string> gap = {".......#..#", "####...#..#", "..........."};
  EXPECT_FALSE(goesOnIn(turned, isInWall));
  EXPECT_TRUE(goesOnIn(turned, isInRoughWall));
  EXPECT_FALSE(goesOnIn(gap, isInRoughWall));
  EXPECT_FALSE(goesOnIn(kUnknown, isInRoughWall));
}

TEST(IsInLongSide, itsSpaceIsLongBesideTheWallAndNotBehindIt) {
  // An opening of three cells in the wall below a space: one as long as 30 cells, or 12; behind it
  // are 6 cells, or 40.
  const auto isOne = [](int length, int behind) {
    const auto side = std::size_t(length / 2);
    std::vector<std::string> rows(4, std::string(2 * side, '.'));
    rows.push_back(std::string(side - 2, '#') + "..." + std::string(side - 1, '#'));
    for (int i = 0; i < behind; ++i)
      rows.push_back(std::string(side - 2, '#') + "..." + std::string(side - 1, '#'));
    rows.push_back(std::string(2 * side, '#'));
    const Grid grid = gridOf(drawn(rows, 1));
    const int y = behind + 1, x = int(side) - 3;
    return isInLongSide(grid, grid.frame.center({x, y}), grid.frame.center({x + 4, y}), 3.5);
  };
  EXPECT_TRUE(isOne(30, 6));
  EXPECT_FALSE(isOne(12, 6));
  EXPECT_FALSE(isOne(30, 40));
}

TEST(IsAcrossOneWidth, aDoorInACorridorIsAndOneInItsSideIsNot) {
  // A door of three cells, with spaces on both sides of its wall, so many cells wide each.
  const auto isOne = [](std::size_t before, std::size_t behind) {
    const auto row = [](std::size_t width) {
      const std::string wall(20 - width / 2, '#');
      return wall + std::string(width, '.') + wall + (width % 2 == 0 ? "" : "#");
    };
    std::vector<std::string> rows(6, row(before));
    rows.push_back(row(3));
    rows.insert(rows.end(), 6, row(behind));
    const Grid grid = gridOf(drawn(rows, 1));
    return isAcrossOneWidth(grid, grid.frame.center({18, 6}), grid.frame.center({22, 6}));
  };
  EXPECT_TRUE(isOne(10, 10));
  EXPECT_TRUE(isOne(10, 13));
  EXPECT_FALSE(isOne(10, 30));
  EXPECT_FALSE(isOne(30, 10));
}

}  // namespace
}  // namespace roomgraph::test
