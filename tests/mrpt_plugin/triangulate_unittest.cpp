#include "triangulate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

double totalArea(const std::vector<Triangle>& triangles) {
  double total = 0;
  for (const Triangle& t : triangles) total += std::abs(cross(t[1] - t[0], t[2] - t[0])) / 2;
  return total;
}

Point middle(const Triangle& t) { return (1.0 / 3) * (t[0] + t[1] + t[2]); }

void expectCovered(const Polygon& polygon) {
  const std::vector<Triangle> triangles = triangulate(polygon);
  EXPECT_NEAR(totalArea(triangles), area(polygon), 1e-9);
  for (const Triangle& t : triangles) EXPECT_EQ(sideOf(polygon, middle(t)), Side::inside);
}

TEST(Triangulate, coversASquare) {
  const Polygon square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}};
  EXPECT_EQ(triangulate(square).size(), 2U);
  expectCovered(square);
}

TEST(Triangulate, coversAConcaveRoom) {
  expectCovered({{{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}, {}});
}

TEST(Triangulate, leavesHolesOpen) {
  expectCovered({{{0, 0}, {6, 0}, {6, 6}, {0, 6}},
                 {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{4, 4}, {4, 5}, {5, 5}, {5, 4}}}});
}

TEST(Triangulate, allowsAHoleThatTouchesTheOutside) {
  expectCovered({{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{{0, 3}, {2, 4}, {2, 2}}}});
}

TEST(Triangulate, allowsARingThatTouchesItself) {
  expectCovered({{{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}, {}});
}

TEST(Triangulate, findsNothingInALine) {
  EXPECT_NEAR(totalArea(triangulate({{{0, 0}, {1, 0}, {2, 0}}, {}})), 0, 1e-12);
}

}  // namespace
}  // namespace roomgraph
