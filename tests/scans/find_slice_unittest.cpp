#include "roomgraph/scans/find_slice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "RandomNumbers.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

/** A room of 8 m by 6 m, as points each 0.1 m: its floor, and walls from one height to another. */
class Room {
 public:
  void addFloor(double z) {
    for (double x = 0; x < 8; x += 0.1)
      for (double y = 0; y < 6; y += 0.1) voxels.add(x + 0.05, y + 0.05, z);
  }
  void addWalls(double low, double high) {
    for (double z = low; z < high; z += 0.1) {
      for (double x = 0; x < 8; x += 0.1)
        for (const double y : {0.0, 6.0}) voxels.add(x + 0.05, y + 0.05, z + 0.05);
      for (double y = 0; y < 6; y += 0.1)
        for (const double x : {0.0, 8.0}) voxels.add(x + 0.05, y + 0.05, z + 0.05);
    }
  }
  Voxels voxels;
};

TEST(FindSlice, theFloorIsWhereMuchIsCovered) {
  Room room;
  room.addFloor(-0.95);
  room.addWalls(-0.9, 1.6);
  room.voxels.add(1, 1, -2.55);  // a reflection from below
  const Slice slice = findSlice(room.voxels, {});
  EXPECT_NEAR(slice.floor, -0.95, 0.06);
  EXPECT_FALSE(slice.isFlat);
  EXPECT_GE(slice.low, 0.2 - 1e-9);
  EXPECT_LE(slice.high, 1.9 + 1e-9);
  EXPECT_NEAR(slice.high - slice.low, 0.5, 1e-9);
}

TEST(FindSlice, theBandIsWhereTheWallsAre) {
  Room room;
  room.addFloor(0.05);
  room.addWalls(1.2, 1.7);  // as of a sensor that looks over tables
  const Slice slice = findSlice(room.voxels, {});
  EXPECT_GT(slice.floor + slice.high, 1.2);
  EXPECT_LT(slice.floor + slice.low, 1.7);
  EXPECT_GT(slice.low, 0.5) << "not where there is nothing";
}

TEST(FindSlice, ofBandsAsGoodTheLowestIsTaken) {
  Room room;
  room.addFloor(0.05);
  room.addWalls(0.1, 2.5);
  EXPECT_NEAR(findSlice(room.voxels, {}).low, 0.2, 1e-9);
}

TEST(FindSlice, aBandThatIsAskedForIsTaken) {
  Room room;
  room.addFloor(0.05);
  room.addWalls(0.1, 2.5);
  LoadGridOptions options;
  options.sliceLow = 0.7, options.sliceHigh = 0.9;
  const Slice slice = findSlice(room.voxels, options);
  EXPECT_EQ(slice.low, 0.7);
  EXPECT_EQ(slice.high, 0.9);
  EXPECT_NEAR(slice.floor, 0.05, 0.06) << "counted from the floor all the same";
}

TEST(FindSlice, aCeilingIsNoFloor) {
  Room room;
  room.addFloor(2.55);
  room.addWalls(0.3, 2.5);
  room.voxels.add(1, 1, 3.95);  // a reflection from above
  const Slice slice = findSlice(room.voxels, {});
  EXPECT_LT(slice.floor, 0.5);
  EXPECT_FALSE(slice.isFloorSeen);
  EXPECT_EQ(sliceText(slice),
            "heights 0.20 to 0.70 m above the lowest walls, as no floor was seen, at 0.35 m");
}

TEST(FindSlice, aFloorIsSeenUnderACeiling) {
  Room room;
  for (const double z : {0.05, 2.55}) room.addFloor(z);
  room.addWalls(0.1, 2.5);
  const Slice slice = findSlice(room.voxels, {});
  EXPECT_NEAR(slice.floor, 0.05, 0.06);
  EXPECT_TRUE(slice.isFloorSeen);
}

TEST(FindSlice, pointsOfOnePlaneAreAllTaken) {
  Room room;
  room.addWalls(0.3, 0.4);
  const Slice slice = findSlice(room.voxels, {});
  EXPECT_TRUE(slice.isFlat);
  EXPECT_TRUE(slice.contains(-10));
  EXPECT_EQ(sliceText(slice), "all points, which lie in one plane");
}

TEST(FindSlice, whatIsThinnerThanABandIsOnePlane) {
  Room room;
  room.addWalls(0.2, 0.6);  // as of a 2D scanner on a robot that rocks
  EXPECT_TRUE(findSlice(room.voxels, {}).isFlat);
}

TEST(FindSlice, aBandWithoutPointsIsToldAndRefused) {
  LoadGridOptions options;
  Room room;
  for (const double z : {0.05, 2.55}) room.addFloor(z);
  room.addWalls(0.1, 2.5);
  options.sliceLow = 2.2, options.sliceHigh = 2.4;
  EXPECT_NO_THROW(refuseEmptySlice(findSlice(room.voxels, options), "run"));
  options.sliceLow = 3, options.sliceHigh = 4;
  const Slice slice = findSlice(room.voxels, options);
  EXPECT_TRUE(slice.isEmpty);
  EXPECT_THROW(refuseEmptySlice(slice, "run"), DataError);
}

TEST(Slice, containsItsBandAndBothEnds) {
  const Slice slice{-1, 0.5, 1, false};
  EXPECT_TRUE(slice.contains(-0.5));
  EXPECT_TRUE(slice.contains(0));
  EXPECT_FALSE(slice.contains(-0.51));
  EXPECT_FALSE(slice.contains(0.01));
  EXPECT_EQ(sliceText(slice), "heights 0.50 to 1.00 m above the floor at -1.00 m");
}

TEST(Voxels, holdEachCubeOnce) {
  Voxels voxels;
  EXPECT_TRUE(voxels.empty());
  for (int i = 0; i < 5; ++i) voxels.add(1.01 + 0.01 * i, -2.05, 0.55);
  voxels.add(1.05, -2.05, 0.75);
  const auto layers = voxels.layers();
  ASSERT_EQ(layers.size(), 3u);
  EXPECT_EQ(layers[0].size(), 1u);
  EXPECT_TRUE(layers[1].empty());
  ASSERT_EQ(layers[2].size(), 1u);
  EXPECT_EQ(layers[0][0].x, 10);
  EXPECT_EQ(layers[0][0].y, -21);
  EXPECT_NEAR(voxels.lowest(), 0.5, 1e-9);
}

TEST(Voxels, leaveOutWhatIsAbsurd) {
  Voxels voxels;
  for (const double bad : {2e4, -2e4, HUGE_VAL, double(NAN)}) voxels.add(bad, 0, 0);
  for (const double bad : {101.0, -101.0, double(NAN)}) voxels.add(0, 0, bad);
  EXPECT_TRUE(voxels.empty());
  voxels.add(-9999, 9999, -99);
  EXPECT_EQ(voxels.layers().size(), 1u);
  EXPECT_EQ(voxels.layers()[0][0].x, -99990);
  EXPECT_EQ(voxels.layers()[0][0].y, 99990);
}

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
