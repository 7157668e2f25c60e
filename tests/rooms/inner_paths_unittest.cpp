#include "roomgraph/rooms/inner_paths.h"

#include <gtest/gtest.h>

#include "square_rooms.h"

namespace roomgraph::test {
namespace {

TEST(InnerPaths, startWhereThePathsComeNearestToTheCentre) {
  const TopologyGraph graph = wayBetweenBorders({{0, 0}, {3, 0}, {8, 0}});
  const InnerPaths inner = innerPaths(graph, {EdgeId(0)}, {VertexId(0), VertexId(1)}, {3, 4}, 0.5);
  EXPECT_EQ(inner.center, (Point{3, 0}));
  ASSERT_EQ(inner.paths.size(), 2u);
  EXPECT_DOUBLE_EQ(inner.paths[0].length, 3);
  EXPECT_DOUBLE_EQ(inner.paths[1].length, 5);
  EXPECT_EQ(inner.paths[1].points.front(), inner.center);
  EXPECT_EQ(inner.paths[1].points.back(), (Point{8, 0}));
}

TEST(InnerPaths, doNotStartInADoor) {
  const TopologyGraph graph = wayBetweenBorders({{0, 0}, {3, 0}, {8, 0}});
  const InnerPaths inner = innerPaths(graph, {EdgeId(0)}, {VertexId(0)}, {-1, 0}, 0.5);
  EXPECT_EQ(inner.center, (Point{3, 0}));
}

TEST(InnerPaths, doNotStartInADoorEvenWhereThereIsNoOtherPoint) {
  const TopologyGraph graph = wayBetweenBorders({{0, 0}, {8, 0}});
  const InnerPaths inner = innerPaths(graph, {EdgeId(0)}, {VertexId(0), VertexId(1)}, {0, 0}, 0.5);
  EXPECT_EQ(inner.center, (Point{4, 0}));
  for (const Path& path : inner.paths) {
    EXPECT_EQ(path.points.size(), 2u);
    EXPECT_DOUBLE_EQ(path.length, 4);
  }
}

TEST(InnerPaths, startAtNoPointThatOnlyRoundingPartsFromADoor) {
  const TopologyGraph graph = wayBetweenBorders({{0, 0}, {1e-9, 0}, {8 - 1e-9, 0}, {8, 0}});
  const InnerPaths inner = innerPaths(graph, {EdgeId(0)}, {VertexId(0), VertexId(1)}, {0, 0}, 0.5);
  EXPECT_EQ(inner.center, (Point{4, 0}));
}

TEST(InnerPaths, takeTheShortestWay) {
  // From (0, 0) to (8, 0) straight on, or round by (4, 9).
  const TopologyGraph graph(
      {{{0, 0}, 1, VertexKind::border, RoomId(0)}, {{8, 0}, 1, VertexKind::border, RoomId(0)}},
      {{VertexId(0), VertexId(1), straight({{0, 0}, {4, 9}, {8, 0}}), RoomId(0)},
       {VertexId(0), VertexId(1), straight({{0, 0}, {1, 0}, {8, 0}}), RoomId(0)}});
  const InnerPaths inner =
      innerPaths(graph, {EdgeId(0), EdgeId(1)}, {VertexId(1), VertexId(0)}, {1, 0}, 0.5);
  ASSERT_EQ(inner.paths.size(), 2u);
  EXPECT_DOUBLE_EQ(inner.paths[0].length, 7);
  EXPECT_DOUBLE_EQ(inner.paths[1].length, 1);
}

TEST(InnerPaths, startWhereThereIsRoomIfThereIsAny) {
  // The obstacles of straight() are 1 m from the middles: nearer ones at the point next to p.
  const TopologyGraph graph(
      {{{0, 0}, 1, VertexKind::deadEnd, RoomId(0)}, {{8, 0}, 1, VertexKind::deadEnd, RoomId(0)}},
      {{VertexId(0), VertexId(1), makePath({{0, 0}, {3, 0}, {8, 0}}, {{3, 0.2}, {8, 2}}),
        RoomId(0)}});
  const auto start = [&](double clearance) {
    return innerPaths(graph, {EdgeId(0)}, {VertexId(0)}, {3, 0}, clearance).center;
  };
  EXPECT_EQ(start(0.1), (Point{3, 0}));
  EXPECT_EQ(start(1), (Point{0, 0}));
  EXPECT_EQ(start(50), (Point{0, 0})) << "nowhere: so half of the 2 m that there are";
}

}  // namespace
}  // namespace roomgraph::test
