#include <gtest/gtest.h>

#include "MapText.h"
#include "hand_built.h"
#include "roomgraph/grid/thin_obstacles.h"
#include "roomgraph/rooms/border_vertices.h"
#include "roomgraph/rooms/cut_paths.h"
#include "roomgraph/rooms/find_rooms.h"
#include "roomgraph/rooms/inner_paths.h"
#include "roomgraph/rooms/join_doors.h"
#include "roomgraph/rooms/room_graph.h"
#include "roomgraph/rooms/room_ids.h"
#include "roomgraph/rooms/short_dead_ends.h"
#include "roomgraph/rooms/trace_rooms.h"
#include "roomgraph/topology/invariants.h"
#include "roomgraph/voronoi/voronoi_graph.h"

namespace roomgraph::test {
namespace {

constexpr double kEpsilon = 1e-8;
constexpr double kClearance = 0.5;

/** A room of 4 x 4 m with its lower left corner at (x, y). */
Room squareRoom(double x, double y) {
  return {{{{x, y}, {x + 4, y}, {x + 4, y + 4}, {x, y + 4}}, {}}, {x + 2, y + 2}, 2};
}

TopologyGraph line(const Polyline& points) {
  return {
      {{points.front(), 1, VertexKind::deadEnd, {}}, {points.back(), 1, VertexKind::deadEnd, {}}},
      {{VertexId(0), VertexId(1), straight(points), {}}}};
}

std::size_t countOf(const TopologyGraph& graph, VertexKind kind) {
  std::size_t count = 0;
  for (const Vertex& v : graph.vertices()) count += v.kind == kind;
  return count;
}

Rooms roomsOf(const MapText& map, double radius) {
  const Grid grid = gridOf(map);
  const VoronoiGraph voronoi = voronoiGraph(obstacleSites(grid, thinObstacles(grid, {}), false));
  KeepInsideOptions options;
  options.outsideWidth = 2 * radius;
  options.freeOnly = false;
  return traceRooms(voronoi, findRooms(voronoi, keepInside(voronoi, grid, options), radius, 0));
}

TEST(FindRooms, aCorridorIsNotARoom) {
  const MapText map = drawn(
      {"#############", "#############", "#...........#", "#...........#", "#############"}, 1);
  EXPECT_TRUE(roomsOf(map, 2).empty());
  EXPECT_EQ(roomsOf(map, 1.2).size(), 1u);
}

TEST(FindRooms, theOuterRingRunsCounterClockwiseAndTheHolesClockwise) {
  std::vector<std::string> rows(20, std::string(20, '.'));
  rows.front() = rows.back() = std::string(20, '#');
  for (auto& row : rows) row.front() = row.back() = '#';
  rows[9][9] = rows[9][10] = rows[10][9] = rows[10][10] = '#';
  const Rooms rooms = roomsOf(drawn(rows, 1), 2);
  ASSERT_EQ(rooms.size(), 1u);
  // The disc does not fill the corners: each loses a triangle with legs of 2.
  EXPECT_DOUBLE_EQ(signedArea(rooms[0].polygon.outer), 19 * 19 - 4 * 2);
  ASSERT_EQ(rooms[0].polygon.holes.size(), 1u);
  EXPECT_DOUBLE_EQ(signedArea(rooms[0].polygon.holes[0]), -1);
}

TEST(FindRooms, aThinWallThatReachesInEnclosesNothing) {
  std::vector<std::string> rows(20, std::string(20, '.'));
  rows.front() = rows.back() = std::string(20, '#');
  for (auto& row : rows) row.front() = row.back() = '#';
  for (std::size_t y = 10; y < 19; ++y) rows[y][9] = '#';
  const Rooms rooms = roomsOf(drawn(rows, 1), 2);
  ASSERT_EQ(rooms.size(), 1u);
  EXPECT_TRUE(rooms[0].polygon.holes.empty());
  // Four corners of the room and two at the foot of the wall.
  EXPECT_DOUBLE_EQ(area(rooms[0].polygon), 19 * 19 - 6 * 2);
  for (const Point p : rooms[0].polygon.outer) {
    EXPECT_TRUE(p.x != 9.5 || p.y < 3 || p.y > 19) << p.y;
  }
}

TEST(FindRooms, aPostThatTouchesTheWallDiagonallyMakesAHole) {
  std::vector<std::string> rows(20, std::string(20, '.'));
  rows.front() = rows.back() = std::string(20, '#');
  for (auto& row : rows) row.front() = row.back() = '#';
  for (std::size_t y : {1, 2, 3})
    for (std::size_t x : {8, 9, 10}) rows[y + 1][x] = '#';
  rows[1][8] = '#';
  const Rooms rooms = roomsOf(drawn(rows, 1), 2);
  ASSERT_EQ(rooms.size(), 1u);
  double sum = signedArea(rooms[0].polygon.outer);
  for (const Ring& hole : rooms[0].polygon.holes) {
    EXPECT_LT(signedArea(hole), 0);
    sum += signedArea(hole);
  }
  EXPECT_DOUBLE_EQ(area(rooms[0].polygon), sum);
  EXPECT_LT(sum, 19 * 19 - 3);
}

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

TEST(CutPaths, putsABorderVertexAtEveryCrossing) {
  const TopologyGraph graph = line({{-3, 2}, {2, 2}, {9, 2}});
  const Rooms rooms{squareRoom(0, 0)};
  const TopologyGraph cut = cutPaths(graph, borderVertices(graph, rooms, kClearance, kEpsilon));
  EXPECT_EQ(cut.edges().size(), 3u);
  EXPECT_EQ(countOf(cut, VertexKind::border), 2u);
  EXPECT_NEAR(distance(cut.vertices()[2].at, {0, 2}), 0, 1e-12);
  EXPECT_EQ(cut.vertices()[2].room, RoomId(0));
  EXPECT_TRUE(brokenInvariants(cut, 0).empty());
}

TEST(RoomIds, aVertexOnThePolygonBecomesABorderVertex) {
  // III-D, case A: the path is crossed at its source or target.
  const Rooms rooms{squareRoom(0, 0)};
  const TopologyGraph graph({{{2, 2}, 1, VertexKind::deadEnd, {}},
                             {{4, 2}, 1, VertexKind::junction, {}},
                             {{9, 2}, 1, VertexKind::deadEnd, {}}},
                            {{VertexId(0), VertexId(1), straight({{2, 2}, {4, 2}}), {}},
                             {VertexId(2), VertexId(1), straight({{9, 2}, {4, 2}}), {}}});
  const auto stretches = borderVertices(graph, rooms, kClearance, kEpsilon);
  EXPECT_EQ(stretches[0].size(), 1u);
  EXPECT_EQ(stretches[1].size(), 1u);
  const TopologyGraph ids = roomIds(cutPaths(graph, stretches), rooms, 1);
  EXPECT_EQ(ids.vertices()[1].kind, VertexKind::border);
  EXPECT_EQ(ids.vertices()[1].room, RoomId(0));
  EXPECT_EQ(ids.vertices()[0].room, RoomId(0));
  EXPECT_FALSE(ids.vertices()[2].room);
}

/** A path from the middle of a room through its right side to `x`. */
TopologyGraph cutAt(double x, const Rooms& rooms, double minLength) {
  const TopologyGraph graph = line({{2, 2}, {x, 2}});
  return roomIds(cutPaths(graph, borderVertices(graph, rooms, kClearance, kEpsilon)), rooms,
                 minLength);
}

TEST(RoomIds, aShortDeadEndBelongsToItsRoom) {
  // III-E, case B.
  const Rooms rooms{squareRoom(0, 0)};
  EXPECT_EQ(cutAt(4.9, rooms, 1).edges()[1].room, RoomId(0));
  EXPECT_FALSE(cutAt(5.1, rooms, 1).edges()[1].room);
}

TEST(RoomIds, aLoneVertexGetsTheRoomAtItsPlace) {
  const TopologyGraph lone(
      {{{1, 1}, 1, VertexKind::junction, {}}, {{9, 1}, 1, VertexKind::junction, {}}}, {});
  const TopologyGraph ids = roomIds(lone, {squareRoom(0, 0)}, 1);
  EXPECT_EQ(ids.vertices()[0].room, RoomId(0));
  EXPECT_FALSE(ids.vertices()[1].room);
}

TEST(RemoveShortDeadEnds, takesTheBorderVertexWithIt) {
  const Rooms rooms{squareRoom(0, 0)};
  const TopologyGraph gone = removeShortDeadEnds(cutAt(4.9, rooms, 1), 1);
  EXPECT_EQ(countOf(gone, VertexKind::border), 0u);
  EXPECT_EQ(gone.edges().size(), 1u);
  const TopologyGraph kept = removeShortDeadEnds(cutAt(5.1, rooms, 1), 1);
  EXPECT_EQ(countOf(kept, VertexKind::border), 1u);
  EXPECT_EQ(kept.edges().size(), 2u);
}

/** A path from room 0 at the origin to room 1 through a door `depth` deep. */
TopologyGraph throughADoor(double depth) {
  const Rooms rooms{squareRoom(0, 0), squareRoom(4 + depth, 0)};
  const TopologyGraph graph = line({{2, 2}, {6 + depth, 2}});
  return roomIds(cutPaths(graph, borderVertices(graph, rooms, kClearance, kEpsilon)), rooms, 1);
}

TEST(JoinDoors, makesOneBorderVertexOfAShallowDoor) {
  JoinDoorsOptions options;
  options.maxDepth = 0.5;
  const TopologyGraph joined = joinDoors(throughADoor(0.4), options);
  EXPECT_EQ(countOf(joined, VertexKind::border), 1u);
  ASSERT_EQ(joined.edges().size(), 2u);
  for (const Vertex& v : joined.vertices())
    EXPECT_TRUE(v.kind != VertexKind::border || distance(v.at, {4.2, 2}) < 1e-12);
  EXPECT_TRUE(brokenInvariants(joined, 0).empty());
  EXPECT_EQ(countOf(joinDoors(throughADoor(0.6), options), VertexKind::border), 2u);
  options.maxDepth = 0;
  EXPECT_EQ(countOf(joinDoors(throughADoor(0.4), options), VertexKind::border), 2u);
}

TEST(JoinDoors, leavesADoorBackIntoTheSameRoom) {
  const Rooms rooms{squareRoom(0, 0)};
  const TopologyGraph graph = line({{2, 1}, {4.1, 1}, {4.1, 1.2}, {2, 1.2}});
  const TopologyGraph cut =
      roomIds(cutPaths(graph, borderVertices(graph, rooms, kClearance, kEpsilon)), rooms, 0);
  JoinDoorsOptions options;
  options.maxDepth = 1;
  EXPECT_EQ(joinDoors(cut, options).edges().size(), cut.edges().size());
}

TEST(InnerPaths, startWhereThePathsComeNearestToTheCentre) {
  const TopologyGraph graph(
      {{{0, 0}, 1, VertexKind::border, RoomId(0)}, {{8, 0}, 1, VertexKind::border, RoomId(0)}},
      {{VertexId(0), VertexId(1), straight({{0, 0}, {3, 0}, {8, 0}}), RoomId(0)}});
  const InnerPaths inner = innerPaths(graph, {EdgeId(0)}, {VertexId(0), VertexId(1)}, {3, 4}, 0.5);
  EXPECT_EQ(inner.center, (Point{3, 0}));
  ASSERT_EQ(inner.paths.size(), 2u);
  EXPECT_DOUBLE_EQ(inner.paths[0].length, 3);
  EXPECT_DOUBLE_EQ(inner.paths[1].length, 5);
  EXPECT_EQ(inner.paths[1].points.front(), inner.center);
  EXPECT_EQ(inner.paths[1].points.back(), (Point{8, 0}));
}

TEST(InnerPaths, doNotStartInADoor) {
  const TopologyGraph graph(
      {{{0, 0}, 1, VertexKind::border, RoomId(0)}, {{8, 0}, 1, VertexKind::border, RoomId(0)}},
      {{VertexId(0), VertexId(1), straight({{0, 0}, {3, 0}, {8, 0}}), RoomId(0)}});
  const InnerPaths inner = innerPaths(graph, {EdgeId(0)}, {VertexId(0)}, {-1, 0}, 0.5);
  EXPECT_EQ(inner.center, (Point{3, 0}));
}

TEST(RoomGraph, numbersRoomsAnewAndTellsOfThoseLeftOut) {
  const Rooms rooms{squareRoom(20, 20), squareRoom(0, 0)};
  const TopologyGraph graph = line({{2, 2}, {9, 2}});
  const TopologyGraph cut =
      roomIds(cutPaths(graph, borderVertices(graph, rooms, kClearance, kEpsilon)), rooms, 1);
  const ObstacleSites none{{1, 1, 1, {}}, {}};
  Notes notes;
  const RoomGraph result = roomGraph(cut, rooms, ObstacleRows(none), kClearance, {}, notes);
  ASSERT_EQ(result.rooms.size(), 1u);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].code, "room_unreached");
  EXPECT_EQ(result.rooms[0].borderVertices.size(), 1u);
  const Vertex& vertex = result.graph.vertex(result.rooms[0].vertex);
  EXPECT_EQ(vertex.room, RoomId(0));
  EXPECT_NEAR(distance(vertex.at, {2, 2}), 0, 1e-12);
}

}  // namespace
}  // namespace roomgraph::test
