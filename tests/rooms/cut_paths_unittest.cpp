#include "roomgraph/rooms/cut_paths.h"

#include <gtest/gtest.h>

#include "invariants.h"
#include "square_rooms.h"

namespace roomgraph::test {
namespace {

TEST(CutPaths, putsABorderVertexAtEveryCrossing) {
  const TopologyGraph graph = line({{-3, 2}, {2, 2}, {9, 2}});
  const Rooms rooms{squareRoom(0, 0)};
  const TopologyGraph cut = cutPaths(graph, borderVertices(graph, rooms, kClearance, kEpsilon));
  EXPECT_EQ(cut.edges().size(), 3u);
  EXPECT_EQ(countOf(cut, VertexKind::border), 2u);
  EXPECT_NEAR(distance(cut.vertices()[2].place, {0, 2}), 0, 1e-12);
  EXPECT_EQ(cut.vertices()[2].room, RoomId(0));
  EXPECT_TRUE(test::brokenInvariants(cut, 0).empty());
}

TEST(CutPaths, aBorderBetweenTwoRoomsGetsTheSmallerId) {
  const TopologyGraph graph = line({{7, 2}, {1, 2}});
  const Rooms rooms{squareRoom(0, 0), squareRoom(4, 0)};
  const TopologyGraph cut = cutPaths(graph, borderVertices(graph, rooms, kClearance, kEpsilon));
  ASSERT_EQ(cut.edges().size(), 2u);
  EXPECT_EQ(cut.edges()[0].room, RoomId(1));
  EXPECT_EQ(cut.edges()[1].room, RoomId(0));
  ASSERT_EQ(countOf(cut, VertexKind::border), 1u);
  EXPECT_EQ(cut.vertices()[2].room, RoomId(0));
}

TEST(CutPaths, leavesAPathInOneStretchWhole) {
  const TopologyGraph graph = line({{1, 1}, {3, 3}});
  const Rooms rooms{squareRoom(0, 0)};
  const TopologyGraph cut = cutPaths(graph, borderVertices(graph, rooms, kClearance, kEpsilon));
  ASSERT_EQ(cut.edges().size(), 1u);
  EXPECT_EQ(cut.edges()[0].room, RoomId(0));
  EXPECT_EQ(cut.edges()[0].path.points, graph.edges()[0].path.points);
  EXPECT_EQ(cut.vertices().size(), 2u);
}

TEST(CutPaths, thePiecesAreAsLongAsThePath) {
  const TopologyGraph graph = line({{-3, 1}, {5, 1}, {5, 3}, {-3, 3}});
  const TopologyGraph cut =
      cutPaths(graph, borderVertices(graph, {squareRoom(0, 0)}, kClearance, kEpsilon));
  ASSERT_EQ(cut.edges().size(), 5u);
  double sum = 0;
  for (const Edge& edge : cut.edges()) sum += edge.path.length;
  EXPECT_NEAR(sum, graph.edges()[0].path.length, 1e-9);
  EXPECT_TRUE(test::brokenInvariants(cut, 0).empty());
}

}  // namespace
}  // namespace roomgraph::test
