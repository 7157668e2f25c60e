#include "roomgraph/align/are_identical.h"

#include <gtest/gtest.h>

#include "drawn_hall.h"

namespace roomgraph {
namespace {

TEST(AreIdentical, aMapAndItsCopyAre) {
  const MapForAlignment hall = mapForAlignment(test::drawnHall(0.1, 0), {});
  EXPECT_TRUE(areIdentical(hall, mapForAlignment(test::drawnHall(0.1, 0), {})));
  EXPECT_TRUE(areIdentical(mapForAlignment(Grid{}, {}), mapForAlignment(Grid{}, {})));
}

TEST(AreIdentical, aMapThatDiffersInAWallOrInItsPlaceIsNot) {
  const MapForAlignment hall = mapForAlignment(test::drawnHall(0.1, 0), {});
  EXPECT_FALSE(areIdentical(hall, mapForAlignment(test::drawnHall(0.1, 0.4), {})));
  Grid moved = test::drawnHall(0.1, 0);
  moved.frame.origin.x += 0.05;
  EXPECT_FALSE(areIdentical(hall, mapForAlignment(moved, {})));
}

}  // namespace
}  // namespace roomgraph
