#include "roomgraph/geometry/Polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {
namespace {

Ring square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

Ring backwards(const Ring& ring) { return {ring.rbegin(), ring.rend()}; }

TEST(Polygon, areaIsPositiveCounterClockwise) {
  EXPECT_DOUBLE_EQ(signedArea(square(3, -2, 2)), 4);
  EXPECT_DOUBLE_EQ(signedArea(backwards(square(3, -2, 2))), -4);
  EXPECT_EQ(signedArea({}), 0);
  EXPECT_EQ(signedArea({{1, 1}, {2, 2}}), 0);
}

TEST(Polygon, perimeterIsThatOfAllRings) {
  EXPECT_DOUBLE_EQ(perimeter({square(3, -2, 2), {}}), 8);
  EXPECT_DOUBLE_EQ(perimeter({square(0, 0, 4), {backwards(square(1, 1, 1))}}), 20);
  EXPECT_EQ(perimeter({}), 0);
}

TEST(Polygon, holesTakeFromTheArea) {
  const Polygon polygon{square(0, 0, 10), {backwards(square(1, 1, 2)), backwards(square(6, 6, 3))}};
  EXPECT_DOUBLE_EQ(area(polygon), 100 - 4 - 9);
}

TEST(Polygon, aMotionMovesAllRings) {
  const Polygon moved = movedBy({square(0, 0, 4), {square(1, 1, 1)}}, Transform2D{5, -2, 0});
  EXPECT_EQ(moved.outer, square(5, -2, 4));
  EXPECT_EQ(moved.holes, std::vector<Ring>{square(6, -1, 1)});
}

TEST(Polygon, centroidWeighsTheHoles) {
  const Polygon whole{square(0, 0, 4), {}};
  EXPECT_NEAR(distance(centroid(whole), {2, 2}), 0, 1e-12);
  const Polygon holed{square(0, 0, 4), {backwards(square(2, 0, 2))}};
  EXPECT_NEAR(centroid(holed).x, (16 * 2 - 4 * 3) / 12.0, 1e-12);
  EXPECT_NEAR(centroid(holed).y, (16 * 2 - 4 * 1) / 12.0, 1e-12);
}

TEST(Polygon, centroidKeepsItsDigitsFarFromTheOrigin) {
  EXPECT_NEAR(distance(centroid({square(1e7, -1e7, 2), {}}), {1e7 + 1, -1e7 + 1}), 0, 1e-8);
}

TEST(Polygon, centroidOfNoAreaIsTheMean) {
  EXPECT_NEAR(distance(centroid({{{0, 0}, {2, 0}, {4, 0}}, {}}), {2, 0}), 0, 1e-12);
}

TEST(Polygon, sideKnowsHolesAndBoundaries) {
  const Polygon polygon{square(0, 0, 10), {backwards(square(4, 4, 2))}};
  EXPECT_EQ(sideOf(polygon, {1, 1}), Side::inside);
  EXPECT_EQ(sideOf(polygon, {5, 5}), Side::outside);
  EXPECT_EQ(sideOf(polygon, {11, 5}), Side::outside);
  EXPECT_EQ(sideOf(polygon, {10, 3}), Side::onBoundary);
  EXPECT_EQ(sideOf(polygon, {4, 5}), Side::onBoundary);
  EXPECT_EQ(sideOf(polygon, {0, 0}), Side::onBoundary);
  // Level with corners of the outer ring and of the hole.
  EXPECT_EQ(sideOf(polygon, {2, 4}), Side::inside);
  EXPECT_EQ(sideOf(polygon, {-1, 0}), Side::outside);
}

TEST(Polygon, sideIsExactForTheNextNumber) {
  const Polygon triangle{{{0, 0}, {1, 1}, {0, 1}}, {}};
  const double x = 1.0 / 3;
  EXPECT_EQ(sideOf(triangle, {x, x}), Side::onBoundary);
  EXPECT_EQ(sideOf(triangle, {std::nextafter(x, 1), x}), Side::outside);
  EXPECT_EQ(sideOf(triangle, {std::nextafter(x, 0), x}), Side::inside);
}

TEST(Polygon, boxHoldsAllPoints) {
  const Box box = boundingBox({{1, 5}, {-2, 3}, {0, 9}});
  EXPECT_EQ(box.low, (Point{-2, 3}));
  EXPECT_EQ(box.high, (Point{1, 9}));
  EXPECT_TRUE(box.contains({1, 9}));
  EXPECT_FALSE(box.contains({1.1, 9}));
}

TEST(Polygon, aBoxGrowsFromNothing) {
  EXPECT_TRUE(boundingBox({}).isEmpty());
  Box box;
  EXPECT_FALSE(box.contains({0, 0}));
  box.include({2, 3});
  EXPECT_FALSE(box.isEmpty());
  EXPECT_EQ(box.size(), (Point{0, 0}));
  box.include({-1, 5});
  EXPECT_EQ(box.size(), (Point{3, 2}));
  EXPECT_EQ(box.widened(1).low, (Point{-2, 2}));
  EXPECT_EQ(box.widened(1).high, (Point{3, 6}));
}

/** A ragged ring about a place; star-shaped, so that it does not cross itself. */
Ring ragged(std::mt19937& random, Point middle, double largest) {
  const auto number = [&](double low, double high) {
    return low + (high - low) * double(random()) / 4294967296.0;
  };
  Ring ring;
  const int corners = 3 + int(random() % 12);
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * M_PI * k / corners, far = number(0.3, 1) * largest;
    ring.push_back(middle + far * Point{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

Polygon anyPolygon(std::mt19937& random) {
  Polygon polygon{ragged(random, {3, -2}, 9), {}};
  // Nothing of the outer ring is nearer to its middle than cos(60 degrees) of the least radius.
  if (random() % 2) polygon.holes.push_back(backwards(ragged(random, {3, -2}, 1.2)));
  return polygon;
}

TEST(Polygon, areaAndMiddleAreThoseOfManyPlaces) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const Polygon polygon = anyPolygon(random);
    const double step = 0.1;
    double count = 0;
    Point sum;
    for (double x = -7 + step / 2; x < 13; x += step)
      for (double y = -12 + step / 2; y < 8; y += step)
        if (sideOf(polygon, {x, y}) == Side::inside) ++count, sum = sum + Point{x, y};
    EXPECT_NEAR(area(polygon), count * step * step, 0.05 * area(polygon) + 0.3) << trial;
    EXPECT_LT(distance(centroid(polygon), (1 / count) * sum), 0.15) << trial;
  }
}

TEST(Polygon, motionsChangeNeitherAreaNorSides) {
  std::mt19937 random(2);
  const auto number = [&] { return 20 * (double(random()) / 4294967296.0 - 0.5); };
  for (int trial = 0; trial < 50; ++trial) {
    const Polygon polygon = anyPolygon(random);
    const Transform2D motion{number(), number(), number()};
    Polygon moved = polygon;
    for (Point& p : moved.outer) p = motion(p);
    for (Ring& hole : moved.holes)
      for (Point& p : hole) p = motion(p);
    EXPECT_NEAR(area(moved), area(polygon), 1e-9);
    EXPECT_NEAR(perimeter(moved), perimeter(polygon), 1e-9);
    EXPECT_LT(distance(centroid(moved), motion(centroid(polygon))), 1e-9);
    for (int i = 0; i < 20; ++i) {
      const Point p{number(), number()};
      EXPECT_EQ(sideOf(moved, motion(p)), sideOf(polygon, p));
    }
  }
}

TEST(Polygon, whereARingStartsChangesNothing) {
  std::mt19937 random(3);
  const Polygon polygon = anyPolygon(random);
  for (std::size_t k = 1; k < polygon.outer.size(); ++k) {
    Polygon other = polygon;
    std::rotate(other.outer.begin(), other.outer.begin() + std::ptrdiff_t(k), other.outer.end());
    EXPECT_NEAR(area(other), area(polygon), 1e-9);
    EXPECT_LT(distance(centroid(other), centroid(polygon)), 1e-9);
    EXPECT_EQ(sideOf(other, {3.1, -2}), sideOf(polygon, {3.1, -2}));
  }
}

TEST(Polygon, aConvexHullLeavesOutWhatLiesInsideAndOnItsSides) {
  EXPECT_EQ(convexHull({{2, 1}, {1, 1}, {0, 0}, {4, 2}, {2, 0}, {4, 0}, {0, 2}, {0, 0}}),
            (Ring{{0, 0}, {4, 0}, {4, 2}, {0, 2}}));
  EXPECT_EQ(convexHull({{1, 1}, {0, 0}, {2, 2}}), (Ring{{0, 0}, {2, 2}}));
  EXPECT_EQ(convexHull({{1, 1}, {1, 1}}), Ring({{1, 1}}));
  EXPECT_TRUE(convexHull({}).empty());
}

TEST(Polygon, theLeastWidthOfAHullDoesNotDependOnItsAngle) {
  for (const double angle : {0.0, 0.3, 1.0, 2.2}) {
    Ring hull{{0, 0}, {4, 0}, {4, 2}, {2, 3}, {0, 2}};
    for (Point& p : hull) p = Transform2D{5, 7, angle}(p);
    EXPECT_NEAR(leastWidth(convexHull(hull)), 3, 1e-9) << angle;
  }
  EXPECT_EQ(leastWidth({{0, 0}, {2, 2}}), 0);
}

}  // namespace
}  // namespace roomgraph
