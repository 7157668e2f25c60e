#include "roomgraph/rooms/room_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cut_graph.h"
#include "invariants.h"

namespace roomgraph::test {
namespace {

const ObstacleCells kNoObstacle{{1, 1, 1, {}}, {}};

TEST(RoomGraph, numbersRoomsAnewAndTellsOfThoseLeftOut) {
  const Rooms rooms{squareRoom(20, 20), squareRoom(0, 0)};
  const TopologyGraph cut = cutAtRooms(line({{2, 2}, {9, 2}}), rooms);
  Notes notes;
  const RoomGraph result = roomGraph(cut, rooms, ObstacleRows(kNoObstacle), kClearance, {}, notes);
  ASSERT_EQ(result.rooms.size(), 1u);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].code, "room_unreached");
  EXPECT_EQ(result.rooms[0].borderVertices.size(), 1u);
  const Vertex& vertex = result.graph.vertex(result.rooms[0].vertex);
  EXPECT_EQ(vertex.room, RoomId(0));
  EXPECT_NEAR(distance(vertex.place, {2, 2}), 0, 1e-12);
}

TEST(RoomGraph, takesWhatIsInsideOutAndJoinsTheRoomToItsBorders) {
  // A crossing in the middle of the room, with two ways out.
  const TopologyGraph graph =
      straightWays({{1.5, 1.5}, {9, 1.5}, {1.5, 9}, {0.5, 0.5}}, {{0, 1}, {0, 2}, {0, 3}});
  const Rooms rooms{squareRoom(0, 0)};
  Notes notes;
  const RoomGraph result =
      roomGraph(cutAtRooms(graph, rooms), rooms, ObstacleRows(kNoObstacle), kClearance, {}, notes);
  EXPECT_TRUE(notes.empty());
  ASSERT_EQ(result.rooms.size(), 1u);
  EXPECT_EQ(result.rooms[0].borderVertices.size(), 2u);
  EXPECT_EQ(countOf(result.graph, VertexKind::room), 1u);
  EXPECT_EQ(countOf(result.graph, VertexKind::junction), 0u) << "it lay inside";
  EXPECT_EQ(result.graph.edges().size(), 4u) << "two in the room, two corridors";
  EXPECT_NEAR(distance(result.rooms[0].center, {2, 2}), 0, 1e-12) << "the centroid";
  EXPECT_TRUE(test::brokenInvariants(result.graph, 0).empty());
}

TEST(RoomGraph, aRoomWithoutAWayOutIsAVertexWithoutEdges) {
  const Rooms rooms{squareRoom(0, 0)};
  Notes notes;
  const RoomGraph result = roomGraph(cutAtRooms(line({{1, 1}, {3, 3}}), rooms), rooms,
                                     ObstacleRows(kNoObstacle), kClearance, {}, notes);
  ASSERT_EQ(result.rooms.size(), 1u);
  EXPECT_TRUE(result.rooms[0].borderVertices.empty());
  EXPECT_EQ(result.graph.vertices().size(), 1u);
  EXPECT_TRUE(result.graph.edges().empty());
}

TEST(RoomGraph, doesNotStandWhereAnObstacleIs) {
  // A pillar at the centroid: the vertex moves onto the path, unless straight edges are asked for.
  const ObstacleCells pillar{{8, 8, 0.5, {0, 0}}, {{3, 3}, {3, 4}, {4, 3}, {4, 4}}};
  const Rooms rooms{squareRoom(0, 0)};
  const TopologyGraph cut = cutAtRooms(line({{1, 0.8}, {3, 0.8}, {9, 0.8}}), rooms);
  Notes notes;
  const auto centre = [&](bool straightEdges) {
    RoomGraphOptions options;
    options.straightEdges = straightEdges;
    return roomGraph(cut, rooms, ObstacleRows(pillar), kClearance, options, notes).rooms[0].center;
  };
  EXPECT_NEAR(distance(centre(true), {2, 2}), 0, 1e-12);
  EXPECT_NEAR(centre(false).y, 0.8, 1e-12);
}

/** A room with four ways out of its middle, and a way on from each. */
TopologyGraph crossing() {
  return straightWays({{2, 2}, {9, 2}, {2, 9}, {-5, 2}, {2, -5}}, {{0, 1}, {0, 2}, {0, 3}, {0, 4}});
}

TEST(RoomGraph, theVertexOfARoomHasAnEdgeToEachOfItsBordersAndToNothingElse) {
  const Rooms rooms{squareRoom(0, 0)};
  Notes notes;
  const RoomGraph result = roomGraph(cutAtRooms(crossing(), rooms), rooms,
                                     ObstacleRows(kNoObstacle), kClearance, {}, notes);
  ASSERT_EQ(result.rooms.size(), 1u);
  const GraphRoom& room = result.rooms[0];
  EXPECT_EQ(room.borderVertices.size(), 4u);
  EXPECT_EQ(result.graph.degree(room.vertex), 4u);
  for (const HalfEdgeId h : result.graph.outgoing(room.vertex)) {
    const VertexId to = result.graph.target(h);
    EXPECT_EQ(std::count(room.borderVertices.begin(), room.borderVertices.end(), to), 1);
    EXPECT_EQ(result.graph.vertex(to).kind, VertexKind::border);
    EXPECT_EQ(result.graph.edge(h).room, RoomId(0));
    EXPECT_NEAR(result.graph.edge(h).path.length, 2, 1e-9);
  }
}

TEST(RoomGraph, whatIsOutsideOfRoomsStaysAsItIs) {
  const Rooms rooms{squareRoom(100, 100)};
  Notes notes;
  const TopologyGraph graph = crossing();
  const RoomGraph result =
      roomGraph(graph, rooms, ObstacleRows(kNoObstacle), kClearance, {}, notes);
  EXPECT_TRUE(result.rooms.empty());
  EXPECT_EQ(notes.size(), 1u);
  ASSERT_EQ(result.graph.vertices().size(), graph.vertices().size());
  for (std::size_t v = 0; v < graph.vertices().size(); ++v) {
    EXPECT_EQ(result.graph.vertices()[v].place, graph.vertices()[v].place);
    EXPECT_EQ(result.graph.vertices()[v].kind, graph.vertices()[v].kind);
  }
  ASSERT_EQ(result.graph.edges().size(), graph.edges().size());
  for (std::size_t e = 0; e < graph.edges().size(); ++e)
    EXPECT_EQ(result.graph.edges()[e].path.points, graph.edges()[e].path.points);
}

TEST(RoomGraph, theWayBetweenTwoRoomsIsKept) {
  const Rooms rooms{squareRoom(0, 0), squareRoom(6, 0)};
  Notes notes;
  const RoomGraph result = roomGraph(cutAtRooms(line({{2, 2}, {8, 2}}), rooms), rooms,
                                     ObstacleRows(kNoObstacle), kClearance, {}, notes);
  ASSERT_EQ(result.rooms.size(), 2u);
  EXPECT_TRUE(notes.empty());
  double corridor = 0;
  for (const Edge& edge : result.graph.edges())
    if (!edge.room) corridor += edge.path.length;
  EXPECT_NEAR(corridor, 2, 1e-9);
  EXPECT_EQ(countOf(result.graph, VertexKind::room), 2u);
  EXPECT_EQ(countOf(result.graph, VertexKind::border), 2u);
  EXPECT_TRUE(test::brokenInvariants(result.graph, 0).empty());
}

TEST(RoomGraph, ofNothingThereIsNothing) {
  Notes notes;
  const RoomGraph result =
      roomGraph(TopologyGraph({}, {}), {}, ObstacleRows(kNoObstacle), kClearance, {}, notes);
  EXPECT_TRUE(result.rooms.empty());
  EXPECT_TRUE(result.graph.vertices().empty());
  EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace roomgraph::test
