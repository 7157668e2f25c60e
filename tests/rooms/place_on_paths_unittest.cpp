#include "place_on_paths.h"

#include <gtest/gtest.h>

#include "square_rooms.h"

namespace roomgraph::test {
namespace {

TEST(PlaceOnPaths, isTheNearestPointThatIsNoBorder) {
  const TopologyGraph graph = wayBetweenBorders({{0, 0}, {3, 0}, {8, 0}});
  EXPECT_DOUBLE_EQ(placeOnPaths(graph, {EdgeId(0)}, {3, 4}, 0.5).along, 3);
  EXPECT_DOUBLE_EQ(placeOnPaths(graph, {EdgeId(0)}, {9, 0}, 0.5).along, 3);
}

TEST(PlaceOnPaths, isHalfwayWhereThereIsNoPoint) {
  EXPECT_DOUBLE_EQ(
      placeOnPaths(wayBetweenBorders({{0, 0}, {8, 0}}), {EdgeId(0)}, {0, 0}, 0.5).along, 4);
}

}  // namespace
}  // namespace roomgraph::test
