#include "roomgraph/topology/join_vertices.h"

#include <gtest/gtest.h>

#include "hand_built.h"
#include "invariants.h"

namespace roomgraph::test {
namespace {

/** Two stars whose centres are `gap` apart. */
TopologyGraph twoStars(double gap) {
  return straightWays({{0, 0}, {gap, 0}, {-3, 1}, {-3, -1}, {5, 1}, {5, -1}},
                      {{0, 1}, {0, 2}, {0, 3}, {1, 4}, {1, 5}});
}

TEST(JoinVertices, makesOneOfTwoThatAreNear) {
  JoinVerticesOptions options;
  options.maxDistance = 0.2;
  const TopologyGraph near = joinVertices(twoStars(0.15), options, 0.1);
  EXPECT_EQ(near.vertices().size(), 5u);
  EXPECT_EQ(near.edges().size(), 4u);
  EXPECT_TRUE(test::brokenInvariants(near, 0).empty());
  EXPECT_EQ(joinVertices(twoStars(0.25), options, 0.1).vertices().size(), 6u);
}

TEST(JoinVertices, countsInCellsWhereAsked) {
  JoinVerticesOptions options;
  options.maxDistance = 0;
  options.maxDistancePx = 4;
  EXPECT_EQ(joinVertices(twoStars(0.35), options, 0.1).vertices().size(), 5u);
  EXPECT_EQ(joinVertices(twoStars(0.45), options, 0.1).vertices().size(), 6u);
}

TEST(JoinVertices, leavesTheTipsOfDeadEnds) {
  EXPECT_EQ(joinVertices(star({0.05, 2, 3}), {}, 0.1).edges().size(), 3u);
}

TEST(JoinVertices, makesASelfLoopOfAWayRoundAnObstacle) {
  JoinVerticesOptions options;
  options.maxDistance = 0.2;
  const TopologyGraph graph =
      joinVertices({{{{0, 0}, 1, kJunction, {}},
                     {{0.1, 0}, 1, kJunction, {}},
                     {{-3, 0}, 1, kDeadEnd, {}},
                     {{3, 0}, 1, kDeadEnd, {}}},
                    {{VertexId(0), VertexId(1), straight({{0, 0}, {0.1, 0}}), {}},
                     {VertexId(0), VertexId(1), straight({{0, 0}, {0, 2}, {0.1, 2}, {0.1, 0}}), {}},
                     {VertexId(0), VertexId(2), straight({{0, 0}, {-3, 0}}), {}},
                     {VertexId(1), VertexId(3), straight({{0.1, 0}, {3, 0}}), {}}}},
                   options, 0.1);
  EXPECT_EQ(graph.vertices().size(), 3u);
  ASSERT_EQ(graph.edges().size(), 3u);
  EXPECT_EQ(graph.edges()[0].source, graph.edges()[0].target);
  EXPECT_TRUE(test::brokenInvariants(graph, 0).empty());
}

TEST(JoinVertices, joinsAWholeGroupIntoTheOneNearestToItsMean) {
  // Three junctions in a row, 0.1 m apart, each with a way out.
  const TopologyGraph graph =
      joinVertices(straightWays({{0, 0}, {0, 5}, {0.1, 0}, {0.1, 5}, {0.2, 0}, {0.2, 5}},
                                {{0, 1}, {2, 3}, {4, 5}, {0, 2}, {2, 4}}),
                   {}, 0.1);
  ASSERT_EQ(graph.vertices().size(), 4u);
  ASSERT_EQ(graph.edges().size(), 3u);
  for (const Edge& edge : graph.edges()) {
    const Vertex& a = graph.vertex(edge.source);
    const Vertex& b = graph.vertex(edge.target);
    const Vertex& junction = a.kind == kJunction ? a : b;
    EXPECT_NEAR(distance(junction.place, {0.1, 0}), 0, 1e-12);
  }
  EXPECT_TRUE(test::brokenInvariants(graph, 0).empty());
}

}  // namespace
}  // namespace roomgraph::test
