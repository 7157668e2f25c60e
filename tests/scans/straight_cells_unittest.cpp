#include "straight_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "RandomNumbers.h"

namespace roomgraph {
namespace {

/** The cells along a straight line from the origin, `thick` of them across. */
std::vector<Cell> lineAt(double degrees, int length, int thick = 1) {
  const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
  std::vector<Cell> cells;
  for (int along = 0; along < length; ++along)
    for (int across = 0; across < thick; ++across)
      cells.push_back(
          {int(std::lround(c * along - s * across)), int(std::lround(s * along + c * across))});
  return cells;
}

TEST(StraightCells, aWallIsStraightWhateverItsDirection) {
  for (int degrees = 0; degrees < 180; degrees += 10) {
    const std::vector<Cell> wall = lineAt(degrees, 30);
    EXPECT_GE(countStraightCells(wall), 24u) << degrees;
  }
}

TEST(StraightCells, aShortPieceIsNone) {
  EXPECT_EQ(countStraightCells(lineAt(0, 9)), 0u);
  EXPECT_EQ(countStraightCells(lineAt(0, 10)), 10u);
}

TEST(StraightCells, aThickPieceIsNone) {
  EXPECT_EQ(countStraightCells(lineAt(0, 40, 3)), 120u);
  EXPECT_LT(countStraightCells(lineAt(0, 40, 12)), 20u) << "of a block its corners at most";
}

TEST(StraightCells, aNarrowGapDoesNotEndAPiece) {
  std::vector<Cell> wall = lineAt(0, 6), wide = wall;
  for (int x = 8; x < 14; ++x) wall.push_back({x, 0});  // two cells are missing
  for (int x = 9; x < 15; ++x) wide.push_back({x, 0});  // three
  EXPECT_EQ(countStraightCells(wall), 12u);
  EXPECT_EQ(countStraightCells(wide), 0u);
}

TEST(StraightCells, scatteredCellsAreNone) {
  test::RandomNumbers random(1);
  std::vector<Cell> cells;
  for (int i = 0; i < 300; ++i) cells.push_back({int(random.below(400)), int(random.below(400))});
  EXPECT_LT(countStraightCells(cells), 10u);
}

TEST(StraightCells, neitherOrderNorRepetitionNorPlaceMatters) {
  test::RandomNumbers random(2);
  std::vector<Cell> cells = lineAt(20, 25);
  for (int i = 0; i < 60; ++i) cells.push_back({int(random.below(60)), int(random.below(60))});
  const std::size_t before = countStraightCells(cells);
  EXPECT_GT(before, 15u);
  std::vector<Cell> again = cells;
  again.insert(again.end(), cells.begin(), cells.begin() + 30);
  random.shuffle(again);
  EXPECT_EQ(countStraightCells(again), before);
  for (Cell& cell : again) cell = {cell.x + 1000, cell.y - 700};
  EXPECT_NEAR(double(countStraightCells(again)), double(before), 6) << "but for rounding";
}

TEST(StraightCells, ofNothingThereAreNone) { EXPECT_EQ(countStraightCells({}), 0u); }

}  // namespace
}  // namespace roomgraph
