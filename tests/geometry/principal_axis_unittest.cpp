#include "roomgraph/geometry/principal_axis.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

PrincipalAxis axisOf(std::initializer_list<Point> points) {
  PointSums sums;
  for (const Point p : points) sums.add(p);
  return principalAxis(sums);
}

TEST(PrincipalAxis, isTheLineOnWhichPointsLie) {
  const PrincipalAxis level = axisOf({{3, 7}, {5, 7}, {7, 7}});
  EXPECT_NEAR(level.direction, 0, 1e-9);
  EXPECT_NEAR(level.along, 8.0 / 3, 1e-9);
  EXPECT_NEAR(level.across, 0, 1e-9);
  EXPECT_NEAR(axisOf({{1, 1}, {2, 2}, {4, 4}}).direction, M_PI / 4, 1e-9);
  EXPECT_NEAR(std::abs(axisOf({{1, 1}, {1, 2}, {1, 4}}).direction), M_PI / 2, 1e-9);
}

TEST(PrincipalAxis, tellsHowFarPointsLieOffIt) {
  const PrincipalAxis box = axisOf({{-4, 1}, {-4, -1}, {4, 1}, {4, -1}});
  EXPECT_NEAR(box.direction, 0, 1e-9);
  EXPECT_NEAR(box.along, 16, 1e-9);
  EXPECT_NEAR(box.across, 1, 1e-9);
}

TEST(PrincipalAxis, pointsThatAreSpreadAllRoundLieAsWidelyAlongAsAcross) {
  const PrincipalAxis round = axisOf({{1, 0}, {-1, 0}, {0, 1}, {0, -1}});
  EXPECT_NEAR(round.along, round.across, 1e-9);
  const PrincipalAxis one = axisOf({{5, 6}});
  EXPECT_NEAR(one.along, 0, 1e-9);
}

}  // namespace
}  // namespace roomgraph
