#include "SiteAreas.h"

#include <gtest/gtest.h>

#include "drawn_areas.h"

namespace roomgraph::test {
namespace {

TEST(SiteAreas, frameHoldsAllOutlinesWithAMargin) {
  const Polygon a{{{1, 1}, {3, 1}, {3, 2}}, {}}, b{{{-4, 0}, {-3, 0}, {-3, 5}}, {}}, empty;
  const GridFrame frame = frameRound({&a, &empty, &b});
  for (const Point p : {Point{-4.4, -0.4}, {3.4, 5.4}})
    EXPECT_TRUE(frame.contains(frame.cellAt(p)));
  EXPECT_DOUBLE_EQ(frame.resolution, 0.1);
  EXPECT_LT(frame.width, 90);
}

TEST(SiteAreas, aLargeSiteHasLargerCells) {
  const Polygon campus{{{0, 0}, {2000, 0}, {2000, 1000}}, {}};
  const GridFrame frame = frameRound({&campus});
  EXPECT_GT(frame.resolution, 1);
  EXPECT_LT(frame.cellCount(), 1100000u);
  EXPECT_EQ(frameRound({}).cellCount(), 0u);
}

TEST(SiteAreas, haveShapesSamplesAndDoors) {
  const RunAreas run = drawnAreas(threeRooms(), threeDoors());
  ASSERT_EQ(run.shapes.size(), 4u);
  const SiteShape& room = run.shapes[1];
  EXPECT_NEAR(room.area, 5 * 2, 1e-9);
  EXPECT_NEAR(distance(room.middle, {8, 6.5}), 0, 1e-9);
  EXPECT_FALSE(room.isCorridor);
  EXPECT_TRUE(run.shapes[3].isCorridor);
  // One sample on each square of 0.2 m.
  EXPECT_NEAR(double(room.samples.size()), 10 / 0.04, 15);
  for (const Point p : room.samples) EXPECT_EQ(sideOf(room.polygon, p), Side::inside);
  EXPECT_EQ(run.doors[1].size(), 2u);
  EXPECT_TRUE(run.isOpenTo(1, 3));
  EXPECT_TRUE(run.isOpenTo(3, 1));
  EXPECT_FALSE(run.isOpenTo(0, 3));
}

TEST(SiteAreas, cellsAreLabelledByTheAreaTheyLieIn) {
  const RunAreas run = drawnAreas(threeRooms());
  const GridFrame frame = frameOf(threeRooms());
  const auto labelAt = [&](Point p) { return run.labels[frame.index(frame.cellAt(p))]; };
  EXPECT_EQ(labelAt({2, 6}), RunAreas::kFirst + 0);
  EXPECT_EQ(labelAt({8, 4}), RunAreas::kFirst + 3);
  EXPECT_EQ(labelAt({0.2, 0.2}), RunAreas::kOccupied);
}

}  // namespace
}  // namespace roomgraph::test
