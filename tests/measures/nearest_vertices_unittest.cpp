#include "roomgraph/measures/nearest_vertices.h"

#include <gtest/gtest.h>

#include "places.h"

namespace roomgraph {
namespace {

TEST(NearestVertices, isTheMeanDistanceOfTheBaseVertices) {
  const auto base = places({{0, 0}, {10, 0}});
  EXPECT_DOUBLE_EQ(nearestVertices(base, places({{3, 4}, {10, 1}})).value(), 3);
  EXPECT_DOUBLE_EQ(nearestVertices(base, base).value(), 0);
}

TEST(NearestVertices, isOneSidedAndLetsOneVertexServeMany) {
  const auto few = places({{0, 0}}), many = places({{0, 0}, {2, 0}, {4, 0}});
  EXPECT_DOUBLE_EQ(nearestVertices(few, many).value(), 0);
  EXPECT_DOUBLE_EQ(nearestVertices(many, few).value(), 2);
}

TEST(NearestVertices, hasNoMeaningForAnEmptyGraph) {
  EXPECT_FALSE(nearestVertices(places({}), places({{0, 0}})));
  EXPECT_FALSE(nearestVertices(places({{0, 0}}), places({})));
}

}  // namespace
}  // namespace roomgraph
