#include "roomgraph/geometry/Polyline.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(Polyline, lengthAndPlacesAlongIt) {
  const Polyline line{{0, 0}, {3, 4}, {3, 4}, {3, 9}};
  EXPECT_DOUBLE_EQ(length(line), 10);
  EXPECT_EQ(length({{1, 1}}), 0);
  EXPECT_EQ(pointAt(line, -1), (Point{0, 0}));
  EXPECT_NEAR(distance(pointAt(line, 2.5), {1.5, 2}), 0, 1e-12);
  EXPECT_NEAR(distance(pointAt(line, 7), {3, 6}), 0, 1e-12);
  EXPECT_EQ(pointAt(line, 99), (Point{3, 9}));
}

TEST(Polyline, distanceToASegmentIsToItsNearestPlace) {
  EXPECT_DOUBLE_EQ(distanceToSegment({1, 2}, {0, 0}, {4, 0}), 2);
  EXPECT_DOUBLE_EQ(distanceToSegment({-3, 4}, {0, 0}, {4, 0}), 5);
  EXPECT_DOUBLE_EQ(distanceToSegment({7, 4}, {0, 0}, {4, 0}), 5);
  EXPECT_DOUBLE_EQ(distanceToSegment({3, 4}, {0, 0}, {0, 0}), 5);
}

}  // namespace
}  // namespace roomgraph
