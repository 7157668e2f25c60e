#include "wall_distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

const WallMap& building() {
  static const WallMap map = wallMap(test::drawnBuilding(3, {}));
  return map;
}

TEST(WallDistances, ofAMapFromItselfAreNothing) {
  const WallDistances own = wallDistances(building(), building(), {});
  EXPECT_EQ(own.count, double(building().walls.size()));
  EXPECT_EQ(own.mean(), 0);
  EXPECT_EQ(own.quantile(0.9), 0);
}

TEST(WallDistances, growWithTheShift) {
  // Walls along the shift stay where they are: about half of all.
  const WallDistances near = wallDistances(building(), building(), {0.1, 0, 0});
  const WallDistances far = wallDistances(building(), building(), {0.3, 0, 0});
  EXPECT_GT(near.mean(), 0.02);
  EXPECT_GT(far.mean(), near.mean() + 0.05);
  EXPECT_LT(far.quantile(0.25), 0.1);
  EXPECT_GT(far.quantile(0.9), 0.25);
}

TEST(WallDistances, whatTheOtherHasNotSeenDoesNotCount) {
  const Grid half = test::drawnBuilding(3, {}, {-1e9, 12});
  const WallDistances both = wallDistances(building(), wallMap(half), {});
  EXPECT_LT(both.count, 0.7 * double(building().walls.size()));
  EXPECT_LT(both.quantile(0.5), 0.02);
  EXPECT_EQ(wallDistances(building(), building(), {500, 0, 0}).count, 0);
}

TEST(WallDistances, withoutPointsAreNothing) {
  EXPECT_EQ(WallDistances().mean(), 0);
  EXPECT_EQ(WallDistances().quantile(0.5), 0);
}

TEST(WallDistances, addUpByWeight) {
  WallDistances sum, other;
  other.sum = 3, other.count = 2, other.histogram[100] = 2;  // two points at half a metre
  sum.sum = 0, sum.count = 2, sum.histogram[0] = 2;
  sum.add(other, 3);
  EXPECT_DOUBLE_EQ(sum.count, 8);
  EXPECT_DOUBLE_EQ(sum.mean(), 9.0 / 8);
  EXPECT_DOUBLE_EQ(sum.quantile(0.2), 0);
  EXPECT_DOUBLE_EQ(sum.quantile(0.5), 0.5);
}

TEST(WallDistances, areThoseToTheNearestWallThatFacesTheSameWay) {
  const Transform2D pose{0.15, -0.1, 0.01};
  const WallDistances found = wallDistances(building(), building(), pose);
  // By plain search; the tables may name a wall that is a little farther.
  double sum = 0, count = 0;
  for (const WallPoint& wall : building().walls) {
    const Point at = pose(wall.place), normal = turned(wall.normal, pose.phi);
    const Cell cell = building().frame.cellAt(at);
    if (!building().frame.contains(cell) ||
        building().states[building().frame.index(cell)] == State::unknown)
      continue;
    double nearest = WallMap::kReach;
    for (const WallPoint& other : building().walls)
      if (dot(other.normal, normal) > 0.7) nearest = std::min(nearest, distance(other.place, at));
    sum += nearest, ++count;
  }
  EXPECT_NEAR(found.count, count, 0.01 * count);
  EXPECT_GE(found.mean(), sum / count - 0.01);
  EXPECT_NEAR(found.mean(), sum / count, 0.03);
}

TEST(WallDistances, theFramesOfTheMapsChangeNothing) {
  const Grid grid = test::drawnBuilding(3, {});
  Grid there = grid;
  there.frame.origin = there.frame.origin + Point{32, -16};
  const WallMap moved = wallMap(there);
  const WallDistances here = wallDistances(building(), building(), {0.2, 0.1, 0});
  const WallDistances other = wallDistances(building(), moved, {32.2, -15.9, 0});
  EXPECT_EQ(here.count, other.count);
  EXPECT_NEAR(here.sum, other.sum, 1e-3 * here.sum) << "but for what lies on a boundary of cells";
}

TEST(WallDistances, quantilesRiseAndTheHistogramHoldsAll) {
  const WallDistances found = wallDistances(building(), building(), {0.3, 0.2, 0.02});
  double last = 0, all = 0;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 0.9, 1.0}) {
    const double value = found.quantile(share);
    EXPECT_GE(value, last) << share;
    EXPECT_LE(value, WallMap::kReach + WallDistances::kStep);
    last = value;
  }
  for (const double count : found.histogram) all += count;
  EXPECT_EQ(all, found.count);
}

TEST(WallDistances, aWallWithNoneInReachIsAsFarAsCanBe) {
  WallMap blank = building();
  for (auto& nearest : blank.nearest)
    nearest = SparseIndices(std::vector<std::uint32_t>(blank.frame.cellCount(), kNoIndex));
  const WallDistances found = wallDistances(building(), blank, {0.01, 0, 0});
  EXPECT_DOUBLE_EQ(found.mean(), WallMap::kReach);
}

}  // namespace
}  // namespace roomgraph
