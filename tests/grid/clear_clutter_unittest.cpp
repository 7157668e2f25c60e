#include "roomgraph/grid/clear_clutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_grid.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph::test {
namespace {

ClearedMap cleared(const Grid& grid, double maxSize) {
  ClearClutterOptions options;
  options.maxSize = maxSize;
  return clearClutter(grid, obstacleCells(grid, thinObstacles(grid, {}), false), options);
}

TEST(ClearClutter, aLimitOfZeroKeepsEvenSingleCells) {
  const Grid grid = gridFrom({".....", ".....", "..#..", ".....", "....."});
  EXPECT_TRUE(cleared(grid, 0).clutter.empty());
  EXPECT_EQ(cleared(grid, 0.1).clutter.size(), 1u);
}

TEST(ClearClutter, freesATableAndTellsOfIt) {
  const Grid grid =
      gridFrom({"########", "#......#", "#.##...#", "#.##...#", "#......#", "########"});
  const ClearedMap map = cleared(grid, 0.5);
  ASSERT_EQ(map.clutter.size(), 1u);
  EXPECT_NEAR(distance(map.clutter[0].center, {1.3, 2.3}), 0, 1e-12) << "metres, map frame";
  EXPECT_NEAR(map.clutter[0].size, 0.1 * (1 + std::sqrt(2)), 1e-12);
  EXPECT_EQ(std::count(map.isClutter.begin(), map.isClutter.end(), 1), 4) << "of the obstacles";
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
  EXPECT_TRUE(cleared(wall, 0.49).clutter.empty());
  EXPECT_EQ(cleared(wall, 0.5).clutter.size(), 1u);
}

TEST(ClearClutter, unknownCellsBelongToTheObstacle) {
  // A table whose inside no scan has seen.
  const Grid grid = gridFrom({".....", ".###.", ".#?#.", ".###.", "....."});
  const ClearedMap map = cleared(grid, 0.5);
  ASSERT_EQ(map.clutter.size(), 1u);
  EXPECT_EQ(std::count(map.grid.cells.begin(), map.grid.cells.end(), State::unknown), 0);
}

/** A room of so many cells of 0.1 m, with one obstacle in it. */
Grid roomWith(int width, int height, Cell low, Cell high) {
  std::vector<std::string> rows(std::size_t(height) + 2, std::string(std::size_t(width) + 2, '#'));
  for (int y = 1; y <= height; ++y)
    for (int x = 1; x <= width; ++x)
      if (x < low.x || x > high.x || y < low.y || y > high.y)
        rows[std::size_t(y)][std::size_t(x)] = '.';
  return gridFrom(rows);
}

TEST(ClearClutter, aTableWithARoomRoundItGoesThoughItIsLarge) {
  EXPECT_EQ(cleared(roomWith(40, 36, {13, 14}, {28, 22}), 1.2).clutter.size(), 1u);
  EXPECT_TRUE(cleared(roomWith(40, 36, {13, 14}, {28, 22}), 0.89).clutter.empty()) << "1.8 m";
}

TEST(ClearClutter, aLargeOneInAHallStays) {
  EXPECT_TRUE(cleared(roomWith(120, 120, {53, 54}, {68, 62}), 1.2).clutter.empty());
}

TEST(ClearClutter, inAWideRoomATableGoesUnlessSomethingIsNear) {
  Grid room = roomWith(64, 60, {24, 26}, {39, 34});
  EXPECT_EQ(cleared(room, 1.2).clutter.size(), 1u);
  for (int x = 1; x < 16; ++x)  // shelves from the wall up to it
    for (int y = 26; y <= 34; ++y) room.cells[room.frame.index({x, y})] = State::occupied;
  EXPECT_TRUE(cleared(room, 1.2).clutter.empty());
}

TEST(ClearClutter, chairsAreNoRoomRoundATable) {
  // In a hall, with chairs on three sides, which come behind the table in the order of rows.
  Grid hall = roomWith(120, 120, {53, 54}, {68, 62});
  for (int y = 60; y <= 80; ++y)
    for (int x = 38; x <= 84; ++x)
      if ((x < 51 || x > 70 || y > 69) && x % 3 != 0 && y % 3 != 2)
        hall.cells[hall.frame.index({x, y})] = State::occupied;
  for (const bool isTurned : {false, true}) {
    if (isTurned) std::reverse(hall.cells.begin(), hall.cells.end());
    const std::vector<Clutter> found = cleared(hall, 1.2).clutter;
    EXPECT_GT(found.size(), 50u);
    EXPECT_TRUE(
        std::all_of(found.begin(), found.end(), [](const Clutter& c) { return c.size < 1; }))
        << "the table goes, turned: " << isTurned;
  }
}

TEST(ClearClutter, aPieceOfWallIsNoTable) {
  EXPECT_TRUE(cleared(roomWith(40, 36, {13, 18}, {28, 19}), 1.2).clutter.empty());
}

TEST(ClearClutter, aCupboardBetweenTwoWaysThroughStays) {
  EXPECT_TRUE(cleared(roomWith(34, 90, {11, 42}, {24, 48}), 1.2).clutter.empty());
}

/** A wall of 0.2 m with gaps, each from one column up to another one. */
Grid wallWithGaps(const std::vector<std::pair<int, int>>& gaps) {
  std::vector<std::string> rows(20, std::string(60, '.'));
  for (const std::size_t y : {9, 10}) {
    rows[y] = std::string(60, '#');
    for (const auto& [from, to] : gaps)
      rows[y].replace(std::size_t(from), std::size_t(to - from), std::size_t(to - from), '.');
  }
  return gridFrom(rows);
}

/** A corridor of 1.6 m, with partitions behind both of its walls, and a post of 0.1 m in it. */
Grid postInCorridor(int wall, int postX) {
  constexpr int kWidth = 100, kHeight = 72, kLow = 20, kHigh = 52;  // cells
  std::vector<std::string> rows(kHeight, std::string(kWidth, '.'));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool isAlong = (y >= kLow - wall && y < kLow) || (y >= kHigh && y < kHigh + wall);
      const bool isPartition = x / wall == 50 / wall && (y < kLow || y >= kHigh);
      const bool isRim = x == 0 || x == kWidth - 1 || y == 0 || y == kHeight - 1;
      if (isAlong || isPartition || isRim) rows[std::size_t(y)][std::size_t(x)] = '#';
    }
  for (const int y : {35, 36})
    for (const int x : {postX, postX + 1}) rows[std::size_t(y)][std::size_t(x)] = '#';
  return gridFrom(rows, 0.05);
}

TEST(ClearClutter, whatStandsInACorridorIsNoWall) {
  for (const int wall : {1, 2, 4})
    for (int postX = 44; postX < 56; ++postX)
      EXPECT_EQ(cleared(postInCorridor(wall, postX), 1.2).clutter.size(), 1u)
          << wall << " at " << postX;
}

TEST(ClearClutter, aPierBetweenTwoDoorsIsWall) {
  EXPECT_TRUE(cleared(wallWithGaps({{15, 24}, {28, 37}}), 1.2).clutter.empty());
  EXPECT_EQ(cleared(wallWithGaps({{5, 24}, {28, 37}}), 1.2).clutter.size(), 1u)
      << "too far from the wall on one side";
}

TEST(ClearClutter, aStubBesideAHoleAndPostsAreWall) {
  EXPECT_TRUE(cleared(wallWithGaps({{15, 24}, {32, 33}}), 1.2).clutter.empty());
  EXPECT_TRUE(cleared(wallWithGaps({{15, 24}, {27, 28}, {31, 32}, {35, 36}}), 1.2).clutter.empty());
}

TEST(ClearClutter, whatStandsInOneDoorIsNoWall) {
  EXPECT_EQ(cleared(wallWithGaps({{20, 24}, {27, 31}}), 1.2).clutter.size(), 1u);
}

TEST(ClearClutter, whatStandsBesideTheLineOfTheWallsIsNoWall) {
  Grid grid = wallWithGaps({{15, 37}});
  for (int x = 24; x < 28; ++x) grid.cells[grid.frame.index({x, 14})] = State::occupied;
  EXPECT_EQ(cleared(grid, 1.2).clutter.size(), 1u);
}

TEST(ClearClutter, aThingIsAsLargeHoweverItIsTurned) {
  for (double turn = 0; turn < M_PI; turn += 0.1) {
    Grid grid = gridFrom(std::vector<std::string>(40, std::string(40, '.')));
    for (int x = 0; x < 40; ++x)
      for (int y = 0; y < 40; ++y) {
        const Point place = roomgraph::turned({x - 19.5, y - 19.5}, turn);
        if (std::abs(place.x) < 8 && std::abs(place.y) < 3)
          grid.cells[grid.frame.index({x, y})] = State::occupied;
      }
    const ClearedMap map = cleared(grid, 2);
    ASSERT_EQ(map.clutter.size(), 1u) << turn;
    EXPECT_NEAR(map.clutter[0].size, 1.71, 0.1) << turn;
  }
}

}  // namespace
}  // namespace roomgraph::test
