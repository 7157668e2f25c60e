#include "roomgraph/rooms/room_ids.h"

#include <gtest/gtest.h>

#include "cut_graph.h"

namespace roomgraph::test {
namespace {

TEST(RoomIds, aVertexOnThePolygonBecomesABorderVertex) {
  // III-D, case A: the path is crossed at its source or target.
  const Rooms rooms{squareRoom(0, 0)};
  const TopologyGraph graph = straightWays({{2, 2}, {4, 2}, {9, 2}}, {{0, 1}, {2, 1}});
  const auto stretches = borderVertices(graph, rooms, kClearance, kEpsilon);
  EXPECT_EQ(stretches[0].size(), 1u);
  EXPECT_EQ(stretches[1].size(), 1u);
  const TopologyGraph ids = roomIds(cutPaths(graph, stretches), rooms);
  EXPECT_EQ(ids.vertices()[1].kind, VertexKind::border);
  EXPECT_EQ(ids.vertices()[1].room, RoomId(0));
  EXPECT_EQ(ids.vertices()[0].room, RoomId(0));
  EXPECT_FALSE(ids.vertices()[2].room);
}

TEST(RoomIds, aLoneVertexGetsTheRoomAtItsPlace) {
  const TopologyGraph ids = roomIds(straightWays({{1, 1}, {9, 1}}, {}), {squareRoom(0, 0)});
  EXPECT_EQ(ids.vertices()[0].room, RoomId(0));
  EXPECT_FALSE(ids.vertices()[1].room);
}

TEST(RoomIds, aPathThatOnlyClipsACornerIsNotInTheRoom) {
  // One way leads through the room, the other, which is not connected to it there, clips it.
  const TopologyGraph graph =
      straightWays({{-3, 2}, {9, 2}, {-1, 2.5}, {1.5, 5}}, {{0, 1}, {2, 3}});
  const TopologyGraph ids = cutAtRooms(graph, {squareRoom(0, 0)});
  ASSERT_EQ(ids.edges().size(), 6u);
  EXPECT_EQ(ids.edges()[1].room, RoomId(0)) << "the long way";
  EXPECT_FALSE(ids.edges()[4].room) << "the corner";
  EXPECT_EQ(countOf(ids, VertexKind::border), 2u) << "those of the long way";
}

}  // namespace
}  // namespace roomgraph::test
