#include "roomgraph/geometry/Polygon.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace roomgraph
