#include "roomgraph/align/wall_quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_building.h"
#include "drawn_hall.h"
#include "roomgraph/align/wall_map.h"
#include "sampled_grid.h"

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

double deviationOf(const Grid& grid) {
  const auto deviation = axisDeviation(wallDirections(wallMap(grid).walls));
  EXPECT_TRUE(deviation);
  return deviation.value_or(-1);
}

TEST(AxisDeviation, isSmallWhereAllWallsAreAtRightAngles) {
  EXPECT_LT(deviationOf(test::drawnBuilding(3, {})), 0.01);
}

TEST(AxisDeviation, doesNotDependOnTheMapsTurn) {
  const double straight = deviationOf(test::drawnBuilding(3, {}));
  for (const double turn : {0.2, 0.785, 1.4, 3.0})
    EXPECT_NEAR(deviationOf(test::drawnBuilding(3, {4, -2, turn})), straight, 0.02) << turn;
}

TEST(AxisDeviation, growsAsAMapBends) {
  const Grid building = test::drawnBuilding(3, {0, 0, 0.2});
  const double straight = deviationOf(building);
  const double little = deviationOf(test::bent(building, 0.08));
  const double much = deviationOf(test::bent(building, 0.2));
  EXPECT_GT(little, straight + 0.015);
  EXPECT_GT(much, little + 0.03);
}

TEST(AxisDeviation, isNotTellableWithoutStraightWalls) {
  EXPECT_FALSE(axisDeviation(wallDirections({})));
  std::vector<WallPoint> circle;  // so narrow that no metre of it is straight
  for (int i = 0; i < 300; ++i) {
    const double angle = 2 * M_PI * i / 300;
    const Point out{std::cos(angle), std::sin(angle)};
    circle.push_back({0.6 * out, out});
  }
  EXPECT_FALSE(axisDeviation(wallDirections(circle)));
}

TEST(WallSharpness, isTheThicknessInCellsWhereAllEndsAtWalls) {
  EXPECT_NEAR(wallSharpness(test::drawnHall(0.05, 0)).value(), 1, 0.03);
  EXPECT_NEAR(wallSharpness(test::drawnHall(0.1, 0)).value(), 2, 0.1);
}

TEST(WallSharpness, wallsThatAreThinnedLowerIt) {
  const Grid hall = test::drawnHall(0.05, 0);
  const Grid frayed = test::redrawn(hall, [&](Cell c) {
    return (c.x + c.y) % 4 != 0 && hall.at(c) == State::occupied ? State::unknown : hall.at(c);
  });
  EXPECT_NEAR(wallSharpness(frayed).value(), 0.25, 0.03);
}

TEST(WallSharpness, anEdgeWhereNobodyLookedOnSaysNothing) {
  const Grid hall = test::drawnHall(0.05, 0);
  const Grid partial = test::redrawn(hall, [&](Cell c) {  // the east was never seen
    return hall.frame.center(c).x > 4 ? State::unknown : hall.at(c);
  });
  EXPECT_NEAR(wallSharpness(partial).value(), 1, 0.06);
}

TEST(WallSharpness, whatLiesDeepInAWallIsNotSeenAsWall) {
  EXPECT_NEAR(wallSharpness(test::drawnHall(0.6, 0)).value(),
              wallSharpness(test::drawnHall(0.9, 0)).value(), 1e-9);
}

TEST(WallSharpness, aMapWithoutWallsHasNone) {
  EXPECT_FALSE(wallSharpness(Grid{}));
  Grid free;
  free.frame = {2, 2, 0.05, {}};
  free.cells.assign(4, State::free);
  EXPECT_FALSE(wallSharpness(free));
}

/** Walls of 5 m that face these ways [rad], each far from the others, as cells of 0.05 m have them:
 *  the normals of slanted ones lie off. */
std::vector<WallPoint> facing(const std::vector<double>& ways) {
  std::vector<WallPoint> walls;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const double steps = std::round(ways[i] / (M_PI / 4)) * (M_PI / 4);
    for (double along = 0; along < 5; along += 0.05)
      walls.push_back({{20.0 * double(i) - along * std::sin(ways[i]), along * std::cos(ways[i])},
                       {std::cos((ways[i] + steps) / 2), std::sin((ways[i] + steps) / 2)}});
  }
  return walls;
}

double directionOf(const std::vector<double>& ways) {
  return mainDirection(wallDirections(facing(ways))).value_or(NAN);
}

TEST(MainDirection, isThatOfMostWallsUpToQuarterTurns) {
  EXPECT_NEAR(directionOf({0, M_PI / 2, M_PI, -M_PI / 2}), 0, 1e-9);
  EXPECT_NEAR(directionOf({0.2, 0.2 + M_PI / 2, 0.2, 0.2, 0.5, 0.7}), 0.2, 1e-3);
  EXPECT_NEAR(std::abs(directionOf({M_PI / 4, -M_PI / 4, M_PI / 4 - 0.01, -M_PI / 4 + 0.01})),
              M_PI / 4, 1e-3);
}

TEST(MainDirection, isNoneWhereFewWallsAreAlike) {
  std::vector<double> all;
  for (int i = 0; i < 12; ++i) all.push_back(i * M_PI / 24);
  EXPECT_TRUE(std::isnan(directionOf(all)));
  EXPECT_FALSE(mainDirection({}));
}

}  // namespace
}  // namespace roomgraph
