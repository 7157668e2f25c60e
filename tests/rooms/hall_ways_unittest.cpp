#include "roomgraph/rooms/hall_ways.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cut_graph.h"
#include "roomgraph/topology/shortest_ways.h"

namespace roomgraph::test {
namespace {

constexpr double kClear = 0.3;  // [m]

/** An empty rectangle from (0, 0) on. */
Room hall(double width, double height) {
  Room room;
  room.polygon.outer = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  room.inscribedRadius = std::min(width, height) / 2;
  room.widestPlace = {width / 2, height / 2};
  return room;
}

/** Its walls of cells of 0.1 m, and more obstacles. */
ObstacleCells wallsOf(const Room& room, const std::vector<Point>& others = {}) {
  const Point corner = room.polygon.outer[2];
  const int width = int(corner.x * 10), height = int(corner.y * 10);
  ObstacleCells cells{{width + 1, height + 1, 0.1, {}}, {}};
  for (int x = 0; x <= width; ++x)
    cells.cells.push_back({x, 0}), cells.cells.push_back({x, height});
  for (int y = 1; y < height; ++y) cells.cells.push_back({0, y}), cells.cells.push_back({width, y});
  for (const Point p : others) cells.cells.push_back(cells.frame.cellAt(p));
  std::sort(cells.cells.begin(), cells.cells.end(),
            [](Cell l, Cell r) { return l.y != r.y ? l.y < r.y : l.x < r.x; });
  return cells;
}

/** Straight ways from a middle to each of these doors. */
TopologyGraph star(Point middle, const std::vector<Point>& doors) {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  for (const Point door : doors) vertices.push_back({door, 0.5, VertexKind::border, {}});
  vertices.push_back({middle, 3, VertexKind::room, {}});
  for (std::size_t i = 0; i < doors.size(); ++i) {
    Edge edge{VertexId(doors.size()), VertexId(i), straight({middle, doors[i]}), {}};
    edge.path.obstacles.clear();  // not known
    edges.push_back(edge);
  }
  return {vertices, edges};
}

double lengthBetween(const TopologyGraph& graph, VertexId a, VertexId b) {
  const std::vector<EdgeId> all = allEdges(graph);
  for (const EdgeId e : all)
    if (graph.edge(e).target == a)
      return ShortestWays(graph, all, {e, graph.edge(e).path.length}).pathTo(b).length;
  return 0;
}

double farthest(const TopologyGraph& graph, Point at) {
  double far = 1e9;
  for (const Edge& edge : graph.edges())
    for (std::size_t i = 0; i + 1 < edge.path.points.size(); ++i)
      far = std::min(far, distanceToSegment(at, edge.path.points[i], edge.path.points[i + 1]));
  return far;
}

TEST(HallWays, aPlainRoomStaysAsItIs) {
  const Room room = hall(6, 12);
  const ObstacleCells walls = wallsOf(room);
  const TopologyGraph ways = star({3, 6}, {{0.1, 1}, {5.9, 1}});
  EXPECT_EQ(hallWays(ways, room, ObstacleRows(walls), kClear).edges().size(), 2u);
}

TEST(HallWays, doorsBesideEachOtherAreJoined) {
  const Room room = hall(12, 12);
  const ObstacleCells walls = wallsOf(room);
  const ObstacleRows rows(walls);
  const TopologyGraph before = star({6, 6}, {{2, 0.4}, {8, 0.4}});
  EXPECT_GT(lengthBetween(before, VertexId(0), VertexId(1)), 1.5 * 6);
  const TopologyGraph ways = hallWays(before, room, rows, kClear);
  EXPECT_LT(lengthBetween(ways, VertexId(0), VertexId(1)), 1.3 * 6);
  for (std::size_t v = 0; v < before.vertices().size(); ++v)
    EXPECT_EQ(ways.vertices()[v].place, before.vertices()[v].place) << "numbers stay";
  for (const Edge& edge : ways.edges())
    for (std::size_t i = 0; i + 1 < edge.path.points.size(); ++i)
      EXPECT_GE(rows.clearance(edge.path.points[i], edge.path.points[i + 1], 9) + 1e-9,
                std::min(edge.path.minClearance, kClear));
}

TEST(HallWays, theyMeetWhereTheyCross) {
  // The way from door 0 to door 1 crosses the one to door 2.
  const Room room = hall(12, 12);
  const ObstacleCells walls = wallsOf(room);
  const TopologyGraph ways =
      hallWays(star({6, 8}, {{2, 0.4}, {10, 0.4}, {6, 0.4}}), room, ObstacleRows(walls), kClear);
  for (std::size_t a = 0; a < ways.edges().size(); ++a)
    for (std::size_t b = a + 1; b < ways.edges().size(); ++b) {
      const Polyline& p = ways.edges()[a].path.points;
      const Polyline& q = ways.edges()[b].path.points;
      const double left = cross(p[1] - p[0], q[0] - p[0]), right = cross(p[1] - p[0], q[1] - p[0]);
      const double above = cross(q[1] - q[0], p[0] - q[0]), below = cross(q[1] - q[0], p[1] - q[0]);
      EXPECT_FALSE(left * right < -1e-6 && above * below < -1e-6) << a << " crosses " << b;
    }
}

TEST(HallWays, allOfTheOpenFloorIsNearAWay) {
  const Room room = hall(20, 14);
  const ObstacleCells walls = wallsOf(room);
  const TopologyGraph before = star({10, 7}, {{19.6, 7}});
  const TopologyGraph ways = hallWays(before, room, ObstacleRows(walls), kClear);
  double worst = 0;
  for (double x = 1.5; x <= 18.5; x += 0.5)
    for (double y = 1.5; y <= 12.5; y += 0.5) worst = std::max(worst, farthest(ways, {x, y}));
  EXPECT_GT(farthest(before, {1.5, 1.5}), 9);
  EXPECT_LT(worst, 4) << "squares of 1.5 m at most 3 m from a way, and half a square";
  EXPECT_LT(ways.edges().size(), 40u);
}

TEST(HallWays, leadFromPlaceToPlaceWithoutGoingFarRound) {
  const Room room = hall(24, 18);
  const ObstacleCells walls = wallsOf(room);
  const TopologyGraph ways =
      hallWays(star({12, 9}, {{4, 17.6}}), room, ObstacleRows(walls), kClear);
  std::vector<double> detours;
  for (std::size_t a = 0; a < ways.vertices().size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const double far = distance(ways.vertices()[a].place, ways.vertices()[b].place);
      const double length = lengthBetween(ways, VertexId(a), VertexId(b));
      if (far > 3 && length > 0) detours.push_back(length / far);
    }
  ASSERT_GT(detours.size(), 100u);
  std::sort(detours.begin(), detours.end());
  EXPECT_LT(detours[detours.size() / 2], 1.3);
  EXPECT_LT(detours[detours.size() * 95 / 100], 1.7);
}

TEST(HallWays, endsThatWaysMeetAreJunctions) {
  const Room room = hall(24, 18);
  const ObstacleCells walls = wallsOf(room);
  const TopologyGraph ways =
      hallWays(star({12, 9}, {{4, 17.6}}), room, ObstacleRows(walls), kClear);
  for (std::size_t v = 0; v < ways.vertices().size(); ++v)
    EXPECT_EQ(ways.vertices()[v].kind == VertexKind::deadEnd,
              ways.degree(VertexId(v)) == 1 && ways.vertices()[v].kind != VertexKind::border)
        << v;
}

TEST(HallWays, noneLeadsThroughAnObstacle) {
  // A wall of cells from below to the middle stands between the doors.
  const Room room = hall(12, 12);
  std::vector<Point> wall;
  for (double y = 0.1; y < 6; y += 0.1) wall.push_back({5, y});
  const ObstacleCells walls = wallsOf(room, wall);
  const ObstacleRows rows(walls);
  const TopologyGraph ways = hallWays(star({6, 8}, {{3, 0.4}, {8, 0.4}}), room, rows, kClear);
  EXPECT_GT(ways.edges().size(), 2u);
  for (std::size_t e = 2; e < ways.edges().size(); ++e) {
    const Path& path = ways.edges()[e].path;
    EXPECT_NEAR(rows.clearance(path.points.front(), path.points.back(), path.minClearance),
                path.minClearance, 1e-9);
    EXPECT_GE(path.minClearance, kClear);
  }
}

TEST(HallWays, aRoomWithoutWaysHasNone) {
  const Room room = hall(12, 12);
  const ObstacleCells walls = wallsOf(room);
  EXPECT_TRUE(hallWays(star({6, 6}, {}), room, ObstacleRows(walls), kClear).edges().empty());
}

}  // namespace
}  // namespace roomgraph::test
