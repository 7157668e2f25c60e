#include "roomgraph/topology/topology_graph.h"

#include <gtest/gtest.h>

namespace roomgraph::test {
namespace {

constexpr auto kDeadEnd = VertexKind::deadEnd;

TEST(MakeTopologyGraph, ofAVoronoiRingHasOneVertex) {
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

TEST(MakeTopologyGraph, runsOfEdgesBecomePathsBetweenJunctions) {
  // A cross whose one arm has a bend.
  VoronoiGraph voronoi;
  voronoi.sites = {{1, 1}, {9, 9}};
  voronoi.vertices = {{{0, 0}, 2}, {{3, 0}, 1}, {{3, 3}, 1}, {{-4, 0}, 1}, {{0, -5}, 1}};
  voronoi.edges = {{0, 1, 0, 1, 1}, {2, 1, 0, 1, 1}, {0, 3, 0, 1, 1}, {4, 0, 0, 1, 1}};
  const TopologyGraph graph = topologyGraph(voronoi, {0, 1, 2, 3});
  ASSERT_EQ(graph.edges().size(), 3u);
  ASSERT_EQ(graph.vertices().size(), 4u);
  EXPECT_EQ(graph.vertices()[0].kind, VertexKind::junction);
  EXPECT_EQ(graph.vertices()[0].clearance, 2);
  double longest = 0;
  for (const Edge& edge : graph.edges()) longest = std::max(longest, edge.path.length);
  EXPECT_DOUBLE_EQ(longest, 6) << "round the bend";
}

TEST(MakeTopologyGraph, aVertexWithoutItsEdgesIsNone) {
  VoronoiGraph voronoi;
  voronoi.sites = {{1, 1}, {9, 9}};
  voronoi.vertices = {{{0, 0}, 2}, {{3, 0}, 1}, {{3, 3}, 1}};
  voronoi.edges = {{0, 1, 0, 1, 1}, {1, 2, 0, 1, 1}};
  EXPECT_EQ(topologyGraph(voronoi, {0}).vertices().size(), 2u);
}

}  // namespace
}  // namespace roomgraph::test
