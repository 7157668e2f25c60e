#include "aliasing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

WallMap mapOf(const Grid& grid) { return wallMap(grid); }

TEST(Aliasing, isFullWhereNothingMoves) {
  EXPECT_GT(aliasingUnder({}, mapOf(test::drawnBuilding(4, {}))), 0.95);
}

TEST(Aliasing, isFullUnderTheTurnsOfASquareHall) {
  const WallMap hall = mapOf(test::squareHall({}));
  const Point middle = hall.middle();
  for (const double turn : {M_PI / 2, M_PI, -M_PI / 2})
    EXPECT_GT(aliasingUnder(carrying(middle, middle, turn), hall), 0.9) << turn;
}

TEST(Aliasing, isLittleInABuildingThatDoesNotRepeatItself) {
  const WallMap map = mapOf(test::drawnBuilding(4, {}));
  const Point middle = map.middle();
  EXPECT_LT(aliasingUnder(carrying(middle, middle, 0.7), map), 0.4);
}

TEST(Aliasing, isNothingBeyondWhatTheMapKnows) {
  EXPECT_EQ(aliasingUnder({500, 0, 0}, mapOf(test::drawnBuilding(4, {}))), 0);
}

TEST(Aliasing, theFrameOfTheMapChangesLittle) {
  const Transform2D pose{13, -8, 0.6};
  const WallMap here = mapOf(test::drawnBuilding(4, {}));
  const WallMap there = mapOf(test::drawnBuilding(4, pose));
  const Point middle = here.middle();
  for (const Transform2D& motion :
       {Transform2D{}, carrying(middle, middle, M_PI), Transform2D{3, 0, 0}}) {
    const double l = aliasingUnder(motion, here);
    const double r = aliasingUnder(pose * motion * pose.inverse(), there);
    EXPECT_NEAR(l, r, 0.15);
  }
}

TEST(Aliasing, aMapWithoutWallsIsLikeNothing) { EXPECT_EQ(aliasingUnder({}, WallMap{}), 0); }

}  // namespace
}  // namespace roomgraph
