#include "path_frechet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {
namespace {

/** Half a circle or all of it, with many or few corners. */
Polyline arc(double radius, double angle, int corners) {
  Polyline line;
  for (int k = 0; k <= corners; ++k) {
    const double phi = angle * k / corners;
    line.push_back({radius * std::cos(phi), radius * std::sin(phi)});
  }
  return line;
}

Polyline moved(Polyline line, const Transform2D& pose) {
  for (Point& p : line) p = pose(p);
  return line;
}

TEST(PathFrechet, aPathMovedAsAWholeIsTheSame) {
  const Transform2D pose{3, -2, 1};
  EXPECT_NEAR(pathFrechet(arc(3, 2, 200), moved(arc(3, 2, 200), pose)).value(), 0, 1e-9);
  const Polyline loop = arc(3, 2 * M_PI, 200);
  EXPECT_NEAR(pathFrechet(loop, moved(loop, pose)).value(), 0, 1e-9);
}

TEST(PathFrechet, aDetourCountsByHowFarItLeads) {
  const Polyline straight{{0, 0}, {4, 0}}, roof{{0, 0}, {2, 1}, {4, 0}};
  EXPECT_NEAR(pathFrechet(straight, roof).value(), 1, 0.1);
}

TEST(PathFrechet, aLongerPathSticksOutAtBothEnds) {
  EXPECT_NEAR(pathFrechet({{0, 0}, {4, 0}}, {{0, 0}, {5, 0}}).value(), 0.5, 1e-9);
}

TEST(PathFrechet, walkingThereAndBackIsNotStayingThere) {
  // Each place of the one is near one of the other, but they are not walked in one order.
  const Polyline once{{0, 0}, {6, 0}}, thrice{{0, 0}, {4, 0}, {2, 0}, {6, 0}};
  EXPECT_GT(pathFrechet(once, thrice).value(), 0.9);
}

TEST(PathFrechet, isTheSameFromBothSidesAndBackwards) {
  const Polyline a = arc(3, 2, 30);
  const Polyline b = moved({{0, 0}, {1, 2}, {3, 2.5}, {4, 1}}, {1, 1, 0.5});
  const double there = pathFrechet(a, b).value();
  EXPECT_GT(there, 0.1);
  EXPECT_NEAR(pathFrechet(b, a).value(), there, 1e-9);
  Polyline backA = a, backB = b;
  std::reverse(backA.begin(), backA.end()), std::reverse(backB.begin(), backB.end());
  EXPECT_NEAR(pathFrechet(backA, backB).value(), there, 1e-9);
}

TEST(PathFrechet, aPathWithoutLengthHasNone) {
  EXPECT_FALSE(pathFrechet({}, {{0, 0}, {1, 0}}));
  EXPECT_FALSE(pathFrechet({{0, 0}, {1, 0}}, {{2, 2}, {2, 2}}));
}

}  // namespace
}  // namespace roomgraph
