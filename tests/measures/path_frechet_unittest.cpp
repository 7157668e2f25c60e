#include "path_frechet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "RandomNumbers.h"
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

/** The Fréchet distance of two rows of places by its definition: the shortest leash with which both
 *  can be walked, by trying all walks. */
double leash(const std::vector<Point>& a, const std::vector<Point>& b, std::size_t i,
             std::size_t j) {
  const double here = distance(a[i], b[j]);
  if (i == 0 && j == 0) return here;
  double before = HUGE_VAL;
  if (i > 0) before = std::min(before, leash(a, b, i - 1, j));
  if (j > 0) before = std::min(before, leash(a, b, i, j - 1));
  if (i > 0 && j > 0) before = std::min(before, leash(a, b, i - 1, j - 1));
  return std::max(here, before);
}

TEST(PathFrechet, isTheShortestLeash) {
  // 2 m are eight steps; both run between the same ends, so that nothing moves.
  test::RandomNumbers random(1);
  for (int trial = 0; trial < 5; ++trial) {
    Polyline a{{0, 0}}, b{{0, 0}};
    std::vector<Point> placesA{{0, 0}}, placesB{{0, 0}};
    for (int k = 1; k < 8; ++k) {  // heights that leave steps of equal length
      const double up = random.between(0.02, 0.1);
      a.push_back({0.25 * k, k % 2 ? up : 0}), b.push_back({0.25 * k, k % 2 ? -up : 0});
    }
    a.push_back({2, 0}), b.push_back({2, 0});
    placesA = a, placesB = b;
    const double slow = leash(placesA, placesB, 8, 8);
    EXPECT_NEAR(pathFrechet(a, b).value(), slow, 0.05);
  }
}

TEST(PathFrechet, cornersThatChangeNothingChangeNothing) {
  const Polyline few{{0, 0}, {3, 0}, {3, 4.1}}, other{{0, 0}, {3, 1}, {3, 4.1}};
  Polyline many;
  for (int k = 0; k < 30; ++k) many.push_back({0.1 * k, 0});
  for (int k = 0; k <= 41; ++k) many.push_back({3, 0.1 * k});
  EXPECT_NEAR(pathFrechet(few, other).value(), pathFrechet(many, other).value(), 1e-6);
}

TEST(PathFrechet, growsWithTheSizeOfThePaths) {
  const Polyline straight{{0, 0}, {4, 0}}, roof{{0, 0}, {2, 1}, {4, 0}};
  Polyline large = roof;
  for (Point& p : large) p = 2.0 * p;
  EXPECT_NEAR(pathFrechet({{0, 0}, {8, 0}}, large).value(), 2 * pathFrechet(straight, roof).value(),
              0.1);
}

TEST(PathFrechet, aMirroredPathIsAnotherOne) {
  Polyline bow = arc(3, 2, 30), mirrored = bow;
  for (Point& p : mirrored) p.y = -p.y;
  EXPECT_GT(pathFrechet(bow, mirrored).value(), 0.5);
}

}  // namespace
}  // namespace roomgraph
