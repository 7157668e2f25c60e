#include "roomgraph/topology/topology_graph.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "RandomNumbers.h"
#include "hand_built.h"

namespace roomgraph::test {
namespace {

TEST(MakeTopologyGraph, ofAVoronoiRingHasOneVertex) {
  VoronoiGraph voronoi;
  voronoi.obstacles = {{1, 1}, {9, 9}};
  voronoi.vertices = {{{0, 0}, 1}, {{2, 0}, 3}, {{2, 2}, 1}, {{0, 2}, 1}};
  for (std::uint32_t v = 0; v < 4; ++v) voronoi.edges.push_back({v, (v + 1) % 4, 0, 1, 1});
  const TopologyGraph ring = topologyGraph(voronoi, {0, 1, 2, 3});
  ASSERT_EQ(ring.vertices().size(), 1u);
  EXPECT_EQ(ring.vertices()[0].kind, VertexKind::ring);
  EXPECT_EQ(ring.vertices()[0].place, (Point{2, 0}));
  EXPECT_DOUBLE_EQ(ring.edges()[0].path.length, 8);
  const TopologyGraph open = topologyGraph(voronoi, {0, 1, 2});
  EXPECT_EQ(open.vertices().size(), 2u);
  EXPECT_EQ(open.vertices()[0].kind, kDeadEnd);
  EXPECT_TRUE(topologyGraph(voronoi, {}).vertices().empty());
}

TEST(MakeTopologyGraph, runsOfEdgesBecomePathsBetweenJunctions) {
  // A cross whose one arm has a bend.
  VoronoiGraph voronoi;
  voronoi.obstacles = {{1, 1}, {9, 9}};
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
  voronoi.obstacles = {{1, 1}, {9, 9}};
  voronoi.vertices = {{{0, 0}, 2}, {{3, 0}, 1}, {{3, 3}, 1}};
  voronoi.edges = {{0, 1, 0, 1, 1}, {1, 2, 0, 1, 1}};
  EXPECT_EQ(topologyGraph(voronoi, {0}).vertices().size(), 2u);
}

/** Places at random, joined at random; all edges between the same two obstacles. */
VoronoiGraph anyVoronoi(RandomNumbers& random) {
  VoronoiGraph voronoi;
  voronoi.obstacles = {{-1, -1}, {50, 50}};
  const std::size_t count = 2 + random.below(30);
  for (std::size_t v = 0; v < count; ++v)
    voronoi.vertices.push_back({random.place(20), random.between(0.5, 3)});
  for (std::size_t e = random.below(50); e > 0; --e) {
    const auto a = std::uint32_t(random.below(count)), b = std::uint32_t(random.below(count));
    if (a != b) voronoi.edges.push_back({a, b, 0, 1, 0.5});
  }
  return voronoi;
}

TEST(MakeTopologyGraph, keepsAllOfWhatIsKeptAndNothingElse) {
  RandomNumbers random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const VoronoiGraph voronoi = anyVoronoi(random);
    EdgeIndices kept;
    double length = 0;
    std::vector<std::size_t> ends(voronoi.vertices.size());
    for (std::uint32_t e = 0; e < voronoi.edges.size(); ++e) {
      if (random.below(4) == 0) continue;
      kept.push_back(e);
      const VoronoiEdge& edge = voronoi.edges[e];
      length += distance(voronoi.vertices[edge.source].place, voronoi.vertices[edge.target].place);
      ++ends[edge.source], ++ends[edge.target];
    }
    const TopologyGraph graph = topologyGraph(voronoi, kept);
    double found = 0;
    for (const Edge& edge : graph.edges()) {
      found += edge.path.length;
      EXPECT_EQ(edge.path.points.front(), graph.vertex(edge.source).place);
      EXPECT_EQ(edge.path.points.back(), graph.vertex(edge.target).place);
    }
    EXPECT_NEAR(found, length, 1e-9 * (1 + length)) << trial;
    std::size_t deadEnds = 0, junctions = 0;
    for (const std::size_t of : ends) deadEnds += of == 1, junctions += of > 2;
    std::size_t foundEnds = 0, foundJunctions = 0;
    for (std::size_t v = 0; v < graph.vertices().size(); ++v) {
      foundEnds += graph.vertices()[v].kind == VertexKind::deadEnd;
      foundJunctions += graph.vertices()[v].kind == VertexKind::junction;
      if (graph.vertices()[v].kind == VertexKind::ring) {
        EXPECT_EQ(graph.degree(VertexId(v)), 2u) << "both ends of its edge";
      }
    }
    EXPECT_EQ(foundEnds, deadEnds);
    EXPECT_EQ(foundJunctions, junctions);
  }
}

TEST(MakeTopologyGraph, theOrderOfWhatIsKeptChangesNoPlace) {
  RandomNumbers random(6);
  for (int trial = 0; trial < 30; ++trial) {
    const VoronoiGraph voronoi = anyVoronoi(random);
    EdgeIndices kept(voronoi.edges.size());
    for (std::uint32_t e = 0; e < kept.size(); ++e) kept[e] = e;
    const auto placesOf = [&](const EdgeIndices& some) {
      const TopologyGraph graph = topologyGraph(voronoi, some);
      std::multiset<Point> places;
      for (const Vertex& vertex : graph.vertices()) places.insert(vertex.place);
      return places;
    };
    const auto before = placesOf(kept);
    random.shuffle(kept);
    EXPECT_EQ(placesOf(kept), before) << trial;
  }
}

}  // namespace
}  // namespace roomgraph::test
