#include "roomgraph/rooms/inner_ways.h"

#include <gtest/gtest.h>

#include "invariants.h"
#include "square_rooms.h"

namespace roomgraph::test {
namespace {

constexpr double kRobot = 0.5, kHalfCell = 0.025;

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
          {edgeOf(1, 0, straight({{0, 0}, {2, 0}}, 0.5)),
           edgeOf(2, 3, straight({{16, 0}, {18, 0}}, 0.5)),
           edgeOf(0, 2, straight({{2, 0}, {2, 2}, {16, 2}, {16, 0}}, 1)),
           edgeOf(0, 2, straight({{2, 0}, {2, -2}, {16, -2}, {16, 0}}, lowerClearance))}};
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
      {edgeOf(0, 1, straight({{2, 2}, {0, 2}}, 0.5)), edgeOf(0, 2, straight({{2, 2}, {2, 0}}, 0.5)),
       edgeOf(0, 3, straight({{2, 2}, {4, 3}}, 1.5))});
  EXPECT_TRUE(waysOf(graph).edges().empty());
}

TEST(InnerWays, leadIntoAnAisleWithoutAnEnd) {
  const auto withAisle = [](double length) {
    return TopologyGraph(
        {vertexOf({2, 2}, 2, VertexKind::junction), vertexOf({0, 2}, 0.5, VertexKind::border),
         vertexOf({2, 0}, 0.5, VertexKind::border),
         vertexOf({4 + length, 2}, 0.6, VertexKind::deadEnd)},
        {edgeOf(0, 1, straight({{2, 2}, {0, 2}}, 0.5)),
         edgeOf(0, 2, straight({{2, 2}, {2, 0}}, 0.5)),
         edgeOf(0, 3, straight({{2, 2}, {4 + length, 2}}, 0.6))});
  };
  EXPECT_EQ(waysOf(withAisle(4)).edges().size(), 3u);
  EXPECT_TRUE(waysOf(withAisle(1)).edges().empty()) << "an alcove";
}

TEST(InnerWays, aNarrowWayStaysWhereNothingElseLeadsOn) {
  TopologyGraph graph = roundAShelf(1);
  std::vector<Vertex> vertices = graph.vertices();
  std::vector<Edge> edges = graph.edges();
  edges[1].path = straight({{16, 0}, {18, 0}}, 0.2);
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

/** From the middle of a room on to where the ways to two doors part, and a stub behind it. */
TopologyGraph forkWithAStub() {
  return {{vertexOf({6, 0}, 1, VertexKind::junction), vertexOf({8, 2}, 0.5, VertexKind::border),
           vertexOf({8, -2}, 0.5, VertexKind::border), vertexOf({-2, 0}, 1, VertexKind::deadEnd)},
          {edgeOf(0, 1, straight({{6, 0}, {8, 2}}, 0.5)),
           edgeOf(0, 2, straight({{6, 0}, {8, -2}}, 0.5)),
           edgeOf(3, 0, straight({{-2, 0}, {0, 0}, {6, 0}}, 1))}};
}

TEST(InnerTree, hasAJunctionWhereTheWaysToTwoDoorsPart) {
  const TopologyGraph graph = forkWithAStub();
  const TopologyGraph tree = innerTree(graph, allEdges(graph), {0, 1}, 0.5);
  ASSERT_EQ(tree.vertices().size(), 4u);
  EXPECT_EQ(tree.vertices()[0].place, (Point{8, 2})) << "border vertices come first";
  EXPECT_EQ(tree.vertices()[1].place, (Point{8, -2}));
  EXPECT_EQ(countOf(tree, VertexKind::junction), 1u);
  ASSERT_EQ(countOf(tree, VertexKind::room), 1u);
  EXPECT_EQ(tree.edges().size(), 3u) << "the stub behind the middle goes";
  for (const Vertex& vertex : tree.vertices())
    if (vertex.kind == VertexKind::room) EXPECT_EQ(vertex.place, (Point{0, 0}));
}

TEST(InnerTree, ofALoopKeepsTheWiderWay) {
  const TopologyGraph graph = roundAShelf(0.27);
  const TopologyGraph tree = innerTree(graph, allEdges(graph), {9, 3}, 0.5);
  EXPECT_EQ(tree.edges().size(), 2u);
  for (const Edge& edge : tree.edges()) EXPECT_GE(edge.path.minClearance, 0.5);
}

TEST(InnerTree, leadsAlongALoopThatStartsAndEndsAtOneDoor) {
  const TopologyGraph graph(
      {vertexOf({0, 0}, 0.5, VertexKind::border)},
      {edgeOf(0, 0, straight({{0, 0}, {4, 1}, {4, 4}, {-4, 4}, {0, 0}}, 0.5))});
  const TopologyGraph tree = innerTree(graph, allEdges(graph), {0, 5}, 0.5);
  ASSERT_EQ(tree.vertices().size(), 2u);
  EXPECT_EQ(tree.vertices()[1].kind, VertexKind::room);
  EXPECT_EQ(tree.edges().size(), 1u);
}

}  // namespace
}  // namespace roomgraph::test
