#include "place_on_paths.h"

#include <gtest/gtest.h>

#include "square_rooms.h"

namespace roomgraph::test {
namespace {

TEST(PlaceOnPaths, isTheNearestPointThatIsNoBorder) {
  const TopologyGraph graph = wayBetweenBorders({{0, 0}, {3, 0}, {8, 0}});
  EXPECT_DOUBLE_EQ(placeOnPaths(graph, {EdgeId(0)}, {3, 4}, 0.5).along, 3);
  EXPECT_DOUBLE_EQ(placeOnPaths(graph, {EdgeId(0)}, {9, 0}, 0.5).along, 3);
  EXPECT_DOUBLE_EQ(placeOnPaths(graph, {EdgeId(0)}, {-1, 0}, 0.5).along, 3);
}

TEST(PlaceOnPaths, isHalfwayWhereThereIsNoPoint) {
  EXPECT_DOUBLE_EQ(
      placeOnPaths(wayBetweenBorders({{0, 0}, {8, 0}}), {EdgeId(0)}, {0, 0}, 0.5).along, 4);
}

TEST(PlaceOnPaths, isNoPointThatOnlyRoundingPartsFromADoor) {
  const TopologyGraph graph = wayBetweenBorders({{0, 0}, {1e-9, 0}, {8 - 1e-9, 0}, {8, 0}});
  EXPECT_DOUBLE_EQ(placeOnPaths(graph, {EdgeId(0)}, {0, 0}, 0.5).along, 4);
}

TEST(PlaceOnPaths, isWhereThereIsRoomIfThereIsAny) {
  // The obstacles of straight() are 1 m from the middles: nearer ones at the point next to p.
  const TopologyGraph graph(
      {{{0, 0}, 1, VertexKind::deadEnd, RoomId(0)}, {{8, 0}, 1, VertexKind::deadEnd, RoomId(0)}},
      {{VertexId(0), VertexId(1), makePath({{0, 0}, {3, 0}, {8, 0}}, {{3, 0.2}, {8, 2}}),
        RoomId(0)}});
  const auto along = [&](double clearance) {
    return placeOnPaths(graph, {EdgeId(0)}, {3, 0}, clearance).along;
  };
  EXPECT_DOUBLE_EQ(along(0.1), 3);
  EXPECT_DOUBLE_EQ(along(1), 0);
  EXPECT_DOUBLE_EQ(along(50), 0) << "nowhere: so half of the 2 m that there are";
}

}  // namespace
}  // namespace roomgraph::test
