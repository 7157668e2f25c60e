#include "roomgraph/geometry/MotionFit.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(MotionFit, findsTheMotionThatMovedThePlaces) {
  const Transform2D moved{3, -2, 2.5};
  MotionFit fit;
  for (const Point p : {Point{0, 0}, {5, 1}, {-2, 4}}) fit.add(p, moved(p));
  EXPECT_NEAR(fit.motion().x, moved.x, 1e-12);
  EXPECT_NEAR(fit.motion().y, moved.y, 1e-12);
  EXPECT_NEAR(fit.motion().phi, moved.phi, 1e-12);
}

TEST(MotionFit, weighsThePlaces) {
  MotionFit fit;
  fit.add({0, 0}, {1, 0}, 3);
  fit.add({0, 0}, {5, 0});
  EXPECT_DOUBLE_EQ(fit.weight(), 4);
  EXPECT_DOUBLE_EQ(fit.motion().x, 2) << "one place has no turn";
  EXPECT_EQ(fit.motion().phi, 0);
}

TEST(MotionFit, ofNothingIsNoMotion) {
  EXPECT_EQ(MotionFit().motion().shift(), (Point{0, 0}));
  EXPECT_EQ(MotionFit().motion().phi, 0);
}

TEST(MotionFit, takesTheSumsOfPointsAsItTakesThePoints) {
  const Transform2D from{1, 2, 0.3}, to{-4, 1, 2}, off{-4, 1.5, 2.2};
  MotionFit bySums, byPoints;
  for (const Transform2D& pose : {to, off}) {
    PointSums sums;
    for (const Point p : {Point{3, 1}, {-2, 5}, {0.5, -1}}) {
      sums.add(p), byPoints.add(from(p), pose(p));
    }
    bySums.add(sums, from, pose);
  }
  EXPECT_NEAR(bySums.motion().phi, byPoints.motion().phi, 1e-12);
  EXPECT_NEAR(bySums.rest(), byPoints.rest(), 1e-12);
  EXPECT_NEAR(bySums.reach(), byPoints.reach(), 1e-12);
}

TEST(MotionFit, hasTheLeastSquaresOfAllMotionsNearIt) {
  const std::vector<std::pair<Point, Point>> pairs{
      {{0, 0}, {0.1, 0}}, {{4, 0}, {4.2, 0.3}}, {{4, 3}, {3.7, 3.4}}, {{0, 3}, {-0.3, 2.8}}};
  MotionFit fit;
  for (const auto& [from, to] : pairs) fit.add(from, to);
  const auto squares = [&](const Transform2D& motion) {
    double sum = 0;
    for (const auto& [from, to] : pairs) sum += squaredNorm(motion(from) - to);
    return sum;
  };
  const Transform2D best = fit.motion();
  EXPECT_NEAR(fit.rest(), std::sqrt(squares(best) / 4), 1e-12);
  for (const double step : {-0.01, 0.01}) {
    EXPECT_GT(squares({best.x + step, best.y, best.phi}), squares(best));
    EXPECT_GT(squares({best.x, best.y + step, best.phi}), squares(best));
    EXPECT_GT(squares({best.x, best.y, best.phi + step}), squares(best));
  }
}

}  // namespace
}  // namespace roomgraph
