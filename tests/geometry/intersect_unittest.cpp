#include "roomgraph/geometry/intersect.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

using Fractions = std::vector<double>;

TEST(Intersect, givesTheFractionOfTheWay) {
  EXPECT_EQ(intersect({0, 0}, {4, 0}, {1, -1}, {1, 3}), Fractions{0.25});
  EXPECT_EQ(intersect({0, 0}, {0, 8}, {-1, 6}, {1, 6}), Fractions{0.75});
  EXPECT_EQ(intersect({0, 0}, {4, 0}, {1, 1}, {1, 3}), Fractions{});
}

TEST(Intersect, countsTouches) {
  EXPECT_EQ(intersect({0, 0}, {4, 0}, {2, 0}, {2, 3}), Fractions{0.5});
  EXPECT_EQ(intersect({0, 0}, {4, 0}, {4, 0}, {9, 3}), Fractions{1});
  EXPECT_EQ(intersect({0, 0}, {4, 0}, {4, 0}, {9, 0}), Fractions{1});
}

TEST(Intersect, givesBothEndsOfAnOverlap) {
  EXPECT_EQ(intersect({0, 0}, {4, 4}, {3, 3}, {1, 1}), (Fractions{0.25, 0.75}));
  EXPECT_EQ(intersect({1, 0}, {2, 0}, {0, 0}, {4, 0}), (Fractions{0, 1}));
  EXPECT_EQ(intersect({0, 0}, {4, 0}, {5, 0}, {6, 0}), Fractions{});
}

TEST(Intersect, handlesPoints) {
  EXPECT_EQ(intersect({1, 0}, {1, 0}, {0, 0}, {4, 0}), Fractions{0});
  EXPECT_EQ(intersect({1, 1}, {1, 1}, {0, 0}, {4, 0}), Fractions{});
}

TEST(Intersect, decidesExactly) {
  // An end on the line to the last bit, and one step beside it.
  const Point a{0, 0}, b{3, 1};
  const Point on{1.5, 0.5};
  EXPECT_EQ(intersect(on, {2, 9}, a, b).size(), 1u);
  EXPECT_EQ(intersect({on.x, std::nextafter(on.y, 1)}, {2, 9}, a, b).size(), 0u);
  EXPECT_EQ(intersect({on.x, std::nextafter(on.y, 0)}, {2, 9}, a, b).size(), 1u);
}

}  // namespace
}  // namespace roomgraph
