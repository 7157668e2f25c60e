#include "roomgraph/rooms/inner_ways.h"

#include <gtest/gtest.h>

#include "invariants.h"
#include "square_rooms.h"

namespace roomgraph::test {
namespace {

constexpr double kRobot = 0.5, kHalfCell = 0.025;

/** A path with the same clearance everywhere. */
Path wayOf(const Polyline& points, double clearance) {
  std::vector<Point> obstacles;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point along = points[i + 1] - points[i];
    const Point aside{-along.y, along.x};
    obstacles.push_back(midpoint(points[i], points[i + 1]) +
                        (clearance / length({points[i], points[i + 1]})) * aside);
  }
  return makePath(points, obstacles);
}

std::vector<EdgeId> allEdges(const TopologyGraph& graph) {
  std::vector<EdgeId> edges;
  for (std::size_t e = 0; e < graph.edges().size(); ++e) edges.push_back(EdgeId(e));
  return edges;
}

TopologyGraph waysOf(const TopologyGraph& graph) {
  return innerWays(graph, allEdges(graph), kRobot, kHalfCell);
}

Edge edgeOf(std::size_t from, std::size_t to, Path path) {
  return {VertexId(from), VertexId(to), std::move(path), RoomId(0)};
}

Vertex vertexOf(Point at, double clearance, VertexKind kind) {
  return {at, clearance, kind, RoomId(0)};
}

/** From the left door to the right one, on two sides of a shelf that is 12 m long. */
TopologyGraph roundAShelf(double lowerClearance) {
  return {{vertexOf({2, 0}, 1, VertexKind::junction), vertexOf({0, 0}, 0.5, VertexKind::border),
           vertexOf({16, 0}, 1, VertexKind::junction), vertexOf({18, 0}, 0.5, VertexKind::border)},
          {edgeOf(1, 0, wayOf({{0, 0}, {2, 0}}, 0.5)), edgeOf(2, 3, wayOf({{16, 0}, {18, 0}}, 0.5)),
           edgeOf(0, 2, wayOf({{2, 0}, {2, 2}, {16, 2}, {16, 0}}, 1)),
           edgeOf(0, 2, wayOf({{2, 0}, {2, -2}, {16, -2}, {16, 0}}, lowerClearance))}};
}

TEST(InnerWays, keepTheLoopRoundAShelf) {
  const TopologyGraph ways = waysOf(roundAShelf(0.6));
  EXPECT_EQ(ways.edges().size(), 4u);
  ASSERT_EQ(ways.vertices().size(), 4u);
  EXPECT_EQ(ways.vertices()[0].place, (Point{0, 0})) << "border vertices come first";
  EXPECT_EQ(ways.vertices()[1].place, (Point{18, 0}));
}

TEST(InnerWays, ofALoopThatIsTooNarrowAreNone) {
  EXPECT_TRUE(waysOf(roundAShelf(0.27)).edges().empty());
}

TEST(InnerWays, ofAPlainRoomAreNone) {
  const TopologyGraph graph(
      {vertexOf({2, 2}, 2, VertexKind::junction), vertexOf({0, 2}, 0.5, VertexKind::border),
       vertexOf({2, 0}, 0.5, VertexKind::border), vertexOf({4, 3}, 1.5, VertexKind::deadEnd)},
      {edgeOf(0, 1, wayOf({{2, 2}, {0, 2}}, 0.5)), edgeOf(0, 2, wayOf({{2, 2}, {2, 0}}, 0.5)),
       edgeOf(0, 3, wayOf({{2, 2}, {4, 3}}, 1.5))});
  EXPECT_TRUE(waysOf(graph).edges().empty());
}

TEST(InnerWays, leadIntoAnAisleWithoutAnEnd) {
  const auto withAisle = [](double length) {
    return TopologyGraph(
        {vertexOf({2, 2}, 2, VertexKind::junction), vertexOf({0, 2}, 0.5, VertexKind::border),
         vertexOf({2, 0}, 0.5, VertexKind::border),
         vertexOf({4 + length, 2}, 0.6, VertexKind::deadEnd)},
        {edgeOf(0, 1, wayOf({{2, 2}, {0, 2}}, 0.5)), edgeOf(0, 2, wayOf({{2, 2}, {2, 0}}, 0.5)),
         edgeOf(0, 3, wayOf({{2, 2}, {4 + length, 2}}, 0.6))});
  };
  EXPECT_EQ(waysOf(withAisle(4)).edges().size(), 3u);
  EXPECT_TRUE(waysOf(withAisle(1)).edges().empty()) << "an alcove";
}

TEST(InnerWays, aNarrowWayStaysWhereNothingElseLeadsOn) {
  TopologyGraph graph = roundAShelf(1);
  std::vector<Vertex> vertices = graph.vertices();
  std::vector<Edge> edges = graph.edges();
  edges[1].path = wayOf({{16, 0}, {18, 0}}, 0.2);
  EXPECT_EQ(waysOf({std::move(vertices), std::move(edges)}).edges().size(), 4u);
}

TEST(WithRoomVertex, cutsTheWayNearestToTheMiddle) {
  const TopologyGraph ways = withRoomVertex(waysOf(roundAShelf(0.6)), {9, 1}, 0.5);
  EXPECT_EQ(countOf(ways, VertexKind::room), 1u);
  EXPECT_TRUE(test::brokenInvariants(ways, 0).empty());
}

TEST(WithRoomVertex, takesAJunctionThatLiesThere) {
  const TopologyGraph ways = withRoomVertex(waysOf(roundAShelf(0.6)), {2, 0}, 0.5);
  EXPECT_EQ(ways.vertices().size(), 4u);
  EXPECT_EQ(ways.edges().size(), 4u);
  EXPECT_EQ(countOf(ways, VertexKind::room), 1u);
}

}  // namespace
}  // namespace roomgraph::test
