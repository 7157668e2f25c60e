#include "roomgraph/align/wall_doubling.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "drawn_hall.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

double doublingOf(const Grid& grid) { return wallDoubling(wallMap(grid)).value(); }

TEST(WallDoubling, aSoundMapHasNearlyNone) {
  EXPECT_LT(doublingOf(test::drawnHall(0.1, 0)), 0.01);
  EXPECT_LT(doublingOf(test::drawnBuilding(1, {3, 4, 0.3})), 0.03) << "thin walls with two sides";
}

TEST(WallDoubling, aCopyOfAWallCountsWithTheWall) {
  // 4 m of the wall's 28 m are there twice; the copy has a back, too.
  const double twice = doublingOf(test::drawnHall(0.1, 0.4));
  EXPECT_GT(twice, 0.16);
  EXPECT_LT(twice, 0.28);
}

TEST(WallDoubling, aWallFartherAwayIsAnotherOne) {
  EXPECT_LT(doublingOf(test::drawnHall(0.1, 1.5)), 0.02);
}

TEST(WallDoubling, aMapWithoutWallsHasNone) { EXPECT_FALSE(wallDoubling(wallMap(Grid{}))); }

}  // namespace
}  // namespace roomgraph
