#include "wall_distances.h"

#include <gtest/gtest.h>

#include "drawn_building.h"

namespace roomgraph {
namespace {

const MapForAlignment& building() {
  static const MapForAlignment map = mapForAlignment(test::drawnBuilding(3, {}), {});
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
  const WallDistances both = wallDistances(building(), mapForAlignment(half, {}), {});
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

}  // namespace
}  // namespace roomgraph
