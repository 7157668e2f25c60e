#include "axis_deviation.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

double deviationOf(const Grid& grid) {
  const auto deviation = axisDeviation(wallMap(grid).walls);
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
  EXPECT_FALSE(axisDeviation({}));
  std::vector<WallPoint> circle;  // so narrow that no metre of it is straight
  for (int i = 0; i < 300; ++i) {
    const double angle = 2 * M_PI * i / 300;
    const Point out{std::cos(angle), std::sin(angle)};
    circle.push_back({0.6 * out, out});
  }
  EXPECT_FALSE(axisDeviation(circle));
}

}  // namespace
}  // namespace roomgraph
