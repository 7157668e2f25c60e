#include "likeness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_building.h"

namespace roomgraph {
namespace {

MapForAlignment mapOf(const Grid& grid) { return mapForAlignment(grid, {}); }

TEST(Likeness, isFullWhereNothingMoves) {
  EXPECT_GT(likenessUnder({}, mapOf(test::drawnBuilding(4, {}))), 0.95);
}

TEST(Likeness, isFullUnderTheTurnsOfASquareHall) {
  const MapForAlignment hall = mapOf(test::squareHall({}));
  const Point middle = hall.middle();
  for (const double turn : {M_PI / 2, M_PI, -M_PI / 2})
    EXPECT_GT(likenessUnder(carrying(middle, middle, turn), hall), 0.9) << turn;
}

TEST(Likeness, isLittleInABuildingThatDoesNotRepeatItself) {
  const MapForAlignment map = mapOf(test::drawnBuilding(4, {}));
  const Point middle = map.middle();
  EXPECT_LT(likenessUnder(carrying(middle, middle, 0.7), map), 0.4);
}

TEST(Likeness, isNothingBeyondWhatTheMapKnows) {
  EXPECT_EQ(likenessUnder({500, 0, 0}, mapOf(test::drawnBuilding(4, {}))), 0);
}

}  // namespace
}  // namespace roomgraph
