#include "roomgraph/rooms/border_vertices.h"

#include <gtest/gtest.h>

#include "square_rooms.h"

namespace roomgraph::test {
namespace {

TEST(BorderVertices, standWhereAPathCrossesARoom) {
  const auto stretches =
      borderVertices(line({{-3, 2}, {2, 2}, {9, 2}}), {squareRoom(0, 0)}, kClearance, kEpsilon);
  ASSERT_EQ(stretches[0].size(), 3u);
  EXPECT_NEAR(stretches[0][0].to, 3, 1e-12);
  EXPECT_NEAR(stretches[0][1].to, 7, 1e-12);
  EXPECT_FALSE(stretches[0][0].room);
  EXPECT_EQ(stretches[0][1].room, RoomId(0));
  EXPECT_FALSE(stretches[0][2].room);
}

TEST(BorderVertices, aTouchIsNoCrossing) {
  const auto outside =
      borderVertices(line({{-3, 5}, {2, 4}, {7, 5}}), {squareRoom(0, 0)}, kClearance, kEpsilon);
  EXPECT_EQ(outside[0].size(), 1u);
  const auto inside =
      borderVertices(line({{1, 1}, {2, 4}, {3, 1}}), {squareRoom(0, 0)}, kClearance, kEpsilon);
  ASSERT_EQ(inside[0].size(), 1u);
  EXPECT_EQ(inside[0][0].room, RoomId(0));
}

TEST(BorderVertices, roomsThatShareAnEdgeShareACrossing) {
  const auto stretches = borderVertices(line({{1, 2}, {7, 2}}),
                                        {squareRoom(0, 0), squareRoom(4, 0)}, kClearance, kEpsilon);
  ASSERT_EQ(stretches[0].size(), 2u);
  EXPECT_EQ(stretches[0][0].room, RoomId(0));
  EXPECT_EQ(stretches[0][1].room, RoomId(1));
}

TEST(BorderVertices, aPathMayCrossOneRoomSeveralTimes) {
  const auto stretches = borderVertices(line({{-1, 1}, {5, 1}, {5, 3}, {-1, 3}}),
                                        {squareRoom(0, 0)}, kClearance, kEpsilon);
  EXPECT_EQ(stretches[0].size(), 5u);
}

TEST(BorderVertices, onlyOpeningsThatTheClearancePassesAreCrossed) {
  // Every side of the room is 4 m long: what keeps 2 m and more from its corners cannot cross it.
  const TopologyGraph graph = line({{-3, 2}, {9, 2}});
  EXPECT_EQ(borderVertices(graph, {squareRoom(0, 0)}, 1.99, kEpsilon)[0].size(), 3u);
  EXPECT_EQ(borderVertices(graph, {squareRoom(0, 0)}, 2.01, kEpsilon)[0].size(), 1u);
}

TEST(BorderVertices, eachEdgeHasItsStretchesWithoutGaps) {
  const TopologyGraph graph = straightWays({{-3, 2}, {2, 2}, {2, 9}}, {{0, 1}, {1, 2}});
  const auto stretches = borderVertices(graph, {squareRoom(0, 0)}, kClearance, kEpsilon);
  ASSERT_EQ(stretches.size(), 2u);
  for (std::size_t e = 0; e < 2; ++e) {
    ASSERT_EQ(stretches[e].size(), 2u);
    EXPECT_EQ(stretches[e][0].from, 0);
    EXPECT_EQ(stretches[e][0].to, stretches[e][1].from);
    EXPECT_EQ(stretches[e][1].to, graph.edges()[e].path.length);
  }
}

}  // namespace
}  // namespace roomgraph::test
