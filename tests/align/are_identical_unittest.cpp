#include "roomgraph/align/are_identical.h"

#include <gtest/gtest.h>

#include "drawn_hall.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

TEST(AreIdentical, aMapAndItsCopyAre) {
  const WallMap hall = wallMap(test::drawnHall(0.1, 0));
  EXPECT_TRUE(areIdentical(hall, wallMap(test::drawnHall(0.1, 0))));
  EXPECT_TRUE(areIdentical(wallMap(Grid{}), wallMap(Grid{})));
}

TEST(AreIdentical, aMapThatDiffersInAWallOrInItsPlaceIsNot) {
  const WallMap hall = wallMap(test::drawnHall(0.1, 0));
  EXPECT_FALSE(areIdentical(hall, wallMap(test::drawnHall(0.1, 0.4))));
  Grid moved = test::drawnHall(0.1, 0);
  moved.frame.origin.x += 0.05;
  EXPECT_FALSE(areIdentical(hall, wallMap(moved)));
}

}  // namespace
}  // namespace roomgraph
