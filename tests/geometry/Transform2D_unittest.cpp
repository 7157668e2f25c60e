#include "roomgraph/geometry/Transform2D.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(Transform2D, turnsFirstAndThenShifts) {
  const Point p = Transform2D{10, 20, M_PI_2}({1, 0});
  EXPECT_NEAR(p.x, 10, 1e-12);
  EXPECT_NEAR(p.y, 21, 1e-12);
}

TEST(Transform2D, theInverseUndoesIt) {
  const Transform2D t{3, -4, 2.9};
  const Point p = t.inverse()(t({7, 8}));
  EXPECT_NEAR(p.x, 7, 1e-12);
  EXPECT_NEAR(p.y, 8, 1e-12);
}

TEST(Transform2D, aProductAppliesItsRightPartFirst) {
  const Transform2D l{1, 2, 3}, r{-2, 0.5, 2};
  const Point one = (l * r)({4, 5}), two = l(r({4, 5}));
  EXPECT_NEAR(one.x, two.x, 1e-12);
  EXPECT_NEAR(one.y, two.y, 1e-12);
  EXPECT_NEAR((l * r).phi, 5 - 2 * M_PI, 1e-12);
}

TEST(Transform2D, carriesOnePlaceToAnother) {
  const Point p = carrying({1, 2}, {-3, 7}, 1.1)({1, 2});
  EXPECT_NEAR(p.x, -3, 1e-12);
  EXPECT_NEAR(p.y, 7, 1e-12);
}

TEST(Transform2D, anglesAreWrappedToAHalfTurn) {
  EXPECT_NEAR(wrappedAngle(3 * M_PI / 2), -M_PI_2, 1e-12);
  EXPECT_EQ(wrappedAngle(-M_PI), M_PI);
  for (double angle = -25; angle < 25; angle += 0.01)
    EXPECT_EQ(wrappedAngle(angle), std::remainder(angle, 2 * M_PI)) << angle;
}

}  // namespace
}  // namespace roomgraph
