#include "likeness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

WallMap mapOf(const Grid& grid) { return wallMap(grid, {}); }

TEST(Likeness, isFullWhereNothingMoves) {
  EXPECT_GT(likenessUnder({}, mapOf(test::drawnBuilding(4, {}))), 0.95);
}

TEST(Likeness, isFullUnderTheTurnsOfASquareHall) {
  const WallMap hall = mapOf(test::squareHall({}));
  const Point middle = hall.middle();
  for (const double turn : {M_PI / 2, M_PI, -M_PI / 2})
    EXPECT_GT(likenessUnder(carrying(middle, middle, turn), hall), 0.9) << turn;
}

TEST(Likeness, isLittleInABuildingThatDoesNotRepeatItself) {
  const WallMap map = mapOf(test::drawnBuilding(4, {}));
  const Point middle = map.middle();
  EXPECT_LT(likenessUnder(carrying(middle, middle, 0.7), map), 0.4);
}

TEST(Likeness, isNothingBeyondWhatTheMapKnows) {
  EXPECT_EQ(likenessUnder({500, 0, 0}, mapOf(test::drawnBuilding(4, {}))), 0);
}

TEST(Likeness, theFrameOfTheMapChangesLittle) {
  const Transform2D pose{13, -8, 0.6};
  const WallMap here = mapOf(test::drawnBuilding(4, {}));
  const WallMap there = mapOf(test::drawnBuilding(4, pose));
  const Point middle = here.middle();
  for (const Transform2D& motion :
       {Transform2D{}, carrying(middle, middle, M_PI), Transform2D{3, 0, 0}}) {
    const double l = likenessUnder(motion, here);
    const double r = likenessUnder(pose * motion * pose.inverse(), there);
    EXPECT_NEAR(l, r, 0.15);
  }
}

TEST(Likeness, aMapWithoutWallsIsLikeNothing) { EXPECT_EQ(likenessUnder({}, WallMap{}), 0); }

}  // namespace
}  // namespace roomgraph
