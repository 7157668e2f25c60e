#include <gtest/gtest.h>

#include <cmath>

#include "hand_built.h"
#include "roomgraph/topology/chains.h"
#include "roomgraph/topology/invariants.h"
#include "roomgraph/topology/topology_graph.h"

namespace roomgraph::test {
namespace {

constexpr auto kJunction = VertexKind::junction;
constexpr auto kDeadEnd = VertexKind::deadEnd;

TEST(Path, knowsLengthAndClearance) {
  const Path path = makePath({{0, 0}, {3, 4}, {3, 10}}, {{0, 1}, {5, 8}});
  EXPECT_DOUBLE_EQ(path.length, 11);
  EXPECT_NEAR(path.minClearance, 0.6, 1e-12);
}

TEST(Path, pieceKeepsWhatItCovers) {
  const Path path = straight({{0, 0}, {4, 0}, {4, 4}});
  const Path middle = piece(path, 1, 6);
  EXPECT_NEAR(distance(middle.points.front(), {1, 0}), 0, 1e-12);
  EXPECT_NEAR(distance(middle.points.back(), {4, 2}), 0, 1e-12);
  EXPECT_EQ(middle.points.size(), 3u);
  EXPECT_EQ(middle.obstacles.size(), 2u);
  EXPECT_EQ(piece(path, 0, path.length).points, path.points);
}

TEST(Path, joinedWithItsReverseComesBack) {
  const Path path = straight({{0, 0}, {4, 0}, {4, 4}});
  const Path round = joined(path, reversed(path));
  EXPECT_DOUBLE_EQ(round.length, 16);
  EXPECT_EQ(round.points.front(), round.points.back());
  EXPECT_EQ(round.points.size(), 5u);
  EXPECT_EQ(round.obstacles.size(), 4u);
}

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
  EXPECT_TRUE(brokenInvariants(graph, 0).empty());
}

TEST(Invariants, nameWhatIsWrong) {
  std::vector<Vertex> vertices{{{0, 0}, 1, kDeadEnd, {}}, {{4, 0}, 1, kDeadEnd, {}}};
  const Path good = straight({{0, 0}, {4, 0}});
  const auto broken = [&](const Path& path, double clearance) {
    return brokenInvariants({vertices, {{VertexId(0), VertexId(1), path, {}}}}, clearance).size();
  };
  EXPECT_EQ(broken(good, 0.5), 0u);
  EXPECT_EQ(broken(good, 1.5), 1u);
  Path tooLong = good;
  tooLong.length = 5;
  EXPECT_EQ(broken(tooLong, 0), 1u);
  EXPECT_EQ(broken(straight({{0, 0}, {3, 0}}), 0), 1u);
  vertices[1].at.x = std::nan("");
  EXPECT_GE(broken(good, 0), 1u);
}

TEST(Invariants, seePathsThatCross) {
  const TopologyGraph graph({{{0, 0}, 1, kDeadEnd, {}},
                             {{4, 4}, 1, kDeadEnd, {}},
                             {{0, 4}, 1, kDeadEnd, {}},
                             {{4, 0}, 1, kDeadEnd, {}}},
                            {{VertexId(0), VertexId(1), straight({{0, 0}, {4, 4}}), {}},
                             {VertexId(2), VertexId(3), straight({{0, 4}, {4, 0}}), {}}});
  EXPECT_EQ(brokenInvariants(graph, 0).size(), 1u);
}

TEST(Chains, aClosedRunGetsItsBestVertex) {
  const std::vector<Link> links{{0, 1}, {1, 2}, {2, 0}};
  const Chains chains = findChains(3, links, {false, false, false},
                                   [](std::uint32_t a, std::uint32_t b) { return a > b; });
  EXPECT_EQ(chains.ringNodes, std::vector<std::uint32_t>{2});
  EXPECT_EQ(chains.count(), 1u);
  EXPECT_EQ(chains.steps.size(), 3u);
}

TEST(Chains, aLinkFromAVertexToItselfIsAChain) {
  const Chains chains =
      findChains(1, {{0, 0}}, {false}, [](std::uint32_t a, std::uint32_t b) { return a < b; });
  EXPECT_EQ(chains.ringNodes, std::vector<std::uint32_t>{0});
  EXPECT_EQ(chains.count(), 1u);
}

TEST(DissolveThrough, makesOneEdgeOfTwo) {
  const TopologyGraph graph = dissolveThrough(
      {{{{0, 0}, 1, kDeadEnd, {}}, {{2, 0}, 1, kJunction, {}}, {{5, 0}, 1, kDeadEnd, {}}},
       {{VertexId(1), VertexId(0), straight({{2, 0}, {0, 0}}), {}},
        {VertexId(1), VertexId(2), straight({{2, 0}, {5, 0}}), {}}}});
  ASSERT_EQ(graph.edges().size(), 1u);
  EXPECT_EQ(graph.vertices().size(), 2u);
  EXPECT_DOUBLE_EQ(graph.edges()[0].path.length, 5);
  EXPECT_TRUE(brokenInvariants(graph, 0).empty());
}

TEST(DissolveThrough, keepsTheWidestOfACycle) {
  const TopologyGraph graph = dissolveThrough(
      {{{{0, 0}, 1, kJunction, {}}, {{4, 0}, 2, kJunction, {}}, {{4, 4}, 1, kJunction, {}}},
       {{VertexId(0), VertexId(1), straight({{0, 0}, {4, 0}}), {}},
        {VertexId(1), VertexId(2), straight({{4, 0}, {4, 4}}), {}},
        {VertexId(2), VertexId(0), straight({{4, 4}, {0, 0}}), {}}}});
  ASSERT_EQ(graph.vertices().size(), 1u);
  EXPECT_EQ(graph.vertices()[0].kind, VertexKind::ring);
  EXPECT_EQ(graph.vertices()[0].at, (Point{4, 0}));
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
  const TopologyGraph graph = dissolveThrough(
      {{{{0, 0}, 1, kDeadEnd, {}}, {{2, 0}, 1, VertexKind::border, {}}, {{5, 0}, 1, kDeadEnd, {}}},
       {{VertexId(0), VertexId(1), straight({{0, 0}, {2, 0}}), {}},
        {VertexId(1), VertexId(2), straight({{2, 0}, {5, 0}}), {}}}});
  EXPECT_EQ(graph.vertices().size(), 3u);
}

TEST(TopologyGraph, ofAVoronoiRingHasOneVertex) {
  VoronoiGraph voronoi;
  voronoi.sites = {{1, 1}, {9, 9}};
  voronoi.vertices = {{{0, 0}, 1}, {{2, 0}, 3}, {{2, 2}, 1}, {{0, 2}, 1}};
  for (std::uint32_t v = 0; v < 4; ++v) voronoi.edges.push_back({v, (v + 1) % 4, 0, 1, 1});
  const TopologyGraph ring = topologyGraph(voronoi, {0, 1, 2, 3});
  ASSERT_EQ(ring.vertices().size(), 1u);
  EXPECT_EQ(ring.vertices()[0].kind, VertexKind::ring);
  EXPECT_EQ(ring.vertices()[0].at, (Point{2, 0}));
  EXPECT_DOUBLE_EQ(ring.edges()[0].path.length, 8);
  const TopologyGraph open = topologyGraph(voronoi, {0, 1, 2});
  EXPECT_EQ(open.vertices().size(), 2u);
  EXPECT_EQ(open.vertices()[0].kind, kDeadEnd);
  EXPECT_TRUE(topologyGraph(voronoi, {}).vertices().empty());
}

}  // namespace
}  // namespace roomgraph::test
