#include "roomgraph/topology/TopologyGraph.h"

#include <gtest/gtest.h>

#include "hand_built.h"
#include "invariants.h"

namespace roomgraph::test {
namespace {

TEST(TopologyGraph, twinsRunBackwards) {
  const TopologyGraph graph = star({2, 3, 4});
  for (std::size_t h = 0; h < 6; ++h) {
    const HalfEdgeId half(h), twin = TopologyGraph::twin(half);
    EXPECT_EQ(TopologyGraph::twin(twin), half);
    EXPECT_EQ(graph.source(half), graph.target(twin));
    EXPECT_EQ(graph.halfPath(half).points.front(), graph.halfPath(twin).points.back());
  }
  EXPECT_EQ(graph.degree(VertexId(0)), 3u);
}

TEST(TopologyGraph, aSelfLoopLeavesTwice) {
  const TopologyGraph graph(
      {{{0, 0}, 1, VertexKind::ring, {}}},
      {{VertexId(0), VertexId(0), straight({{0, 0}, {4, 0}, {4, 4}, {0, 0}}), {}}});
  EXPECT_EQ(graph.degree(VertexId(0)), 2u);
  EXPECT_FALSE(graph.isDeadEnd(EdgeId(0)));
  EXPECT_TRUE(test::brokenInvariants(graph, 0).empty());
}

TEST(DissolveThrough, makesOneEdgeOfTwo) {
  const TopologyGraph graph =
      dissolveThrough(straightWays({{0, 0}, {2, 0}, {5, 0}}, {{1, 0}, {1, 2}}));
  ASSERT_EQ(graph.edges().size(), 1u);
  EXPECT_EQ(graph.vertices().size(), 2u);
  EXPECT_DOUBLE_EQ(graph.edges()[0].path.length, 5);
  EXPECT_TRUE(test::brokenInvariants(graph, 0).empty());
}

TEST(DissolveThrough, keepsTheWidestOfACycle) {
  const TopologyGraph graph = dissolveThrough(
      joinedUp({{{0, 0}, 1, kJunction, {}}, {{4, 0}, 2, kJunction, {}}, {{4, 4}, 1, kJunction, {}}},
               {{0, 1}, {1, 2}, {2, 0}}));
  ASSERT_EQ(graph.vertices().size(), 1u);
  EXPECT_EQ(graph.vertices()[0].kind, VertexKind::ring);
  EXPECT_EQ(graph.vertices()[0].place, (Point{4, 0}));
  ASSERT_EQ(graph.edges().size(), 1u);
  EXPECT_EQ(graph.edges()[0].source, graph.edges()[0].target);
}

TEST(DissolveThrough, leavesASelfLoopWithABranch) {
  const TopologyGraph graph =
      dissolveThrough({{{{0, 0}, 1, kJunction, {}}, {{-3, 0}, 1, kDeadEnd, {}}},
                       {{VertexId(0), VertexId(0), straight({{0, 0}, {4, 0}, {4, 4}, {0, 0}}), {}},
                        {VertexId(0), VertexId(1), straight({{0, 0}, {-3, 0}}), {}}}});
  EXPECT_EQ(graph.vertices().size(), 2u);
  EXPECT_EQ(graph.edges().size(), 2u);
  EXPECT_EQ(graph.vertices()[0].kind, kJunction);
}

TEST(DissolveThrough, leavesOtherKindsAlone) {
  const TopologyGraph graph = dissolveThrough(joinedUp(
      {{{0, 0}, 1, kDeadEnd, {}}, {{2, 0}, 1, VertexKind::border, {}}, {{5, 0}, 1, kDeadEnd, {}}},
      {{0, 1}, {1, 2}}));
  EXPECT_EQ(graph.vertices().size(), 3u);
}

TEST(KeepOnly, dropsWhatIsNotFlaggedAndNumbersTheRestAnew) {
  const TopologyGraph graph = star({2, 3, 4});
  const TopologyGraph kept = keepOnly(graph, {true, false, true, true}, {false, true, true});
  ASSERT_EQ(kept.vertices().size(), 3u);
  ASSERT_EQ(kept.edges().size(), 2u);
  EXPECT_EQ(kept.vertices()[1].place, graph.vertices()[2].place);
  EXPECT_EQ(kept.edges()[1].target, VertexId(2));
  EXPECT_DOUBLE_EQ(kept.edges()[1].path.length, 4);
}

TEST(TopologyGraph, knowsItsDeadEnds) {
  const TopologyGraph graph = star({2, 3, 4});
  for (std::size_t e = 0; e < 3; ++e) EXPECT_TRUE(graph.isDeadEnd(EdgeId(e)));
  EXPECT_EQ(graph.degree(VertexId(1)), 1u);
}

}  // namespace
}  // namespace roomgraph::test
