#include "roomgraph/voronoi/keep_clear.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_sites.h"
#include "random_maps.h"
#include "roomgraph/voronoi/voronoi_graph.h"

namespace roomgraph::test {
namespace {

TEST(KeepClear, keepsTheFiniteEdgesThatAreWideEnough) {
  const VoronoiGraph voronoi = voronoiGraph(sitesOf(randomMap(4, 40, 30, 0.1)));
  const InsideFlags all(voronoi.vertices.size(), 1);
  const EdgeIndices kept = keepClear(voronoi, all, 0.25);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  std::size_t expected = 0;
  for (const VoronoiEdge& edge : voronoi.edges)
    expected += !edge.isInfinite() && edge.minClearance >= 0.25;
  EXPECT_EQ(kept.size(), expected);
  EXPECT_GT(expected, 0u);
  EXPECT_TRUE(keepClear(voronoi, InsideFlags(voronoi.vertices.size(), 0), 0.25).empty());
}

TEST(KeepClear, neverGoesBelowThreeQuartersOfACell) {
  KeepClearOptions options;
  options.minClearance = 0.01;
  EXPECT_DOUBLE_EQ(effectiveClearance(options, 0.1), 0.075);
  options.minClearance = 0.3;
  EXPECT_DOUBLE_EQ(effectiveClearance(options, 0.1), 0.3);
}

TEST(KeepClear, neitherEndMayLieOutside) {
  VoronoiGraph voronoi;
  voronoi.vertices = {{{0, 0}, 1}, {{1, 0}, 1}, {{2, 0}, 1}};
  voronoi.edges = {{0, 1, 0, 1, 1}, {1, 2, 0, 1, 1}};
  EXPECT_EQ(keepClear(voronoi, {1, 1, 0}, 0.5), (EdgeIndices{0}));
  EXPECT_EQ(keepClear(voronoi, {1, 0, 1}, 0.5), EdgeIndices{});
}

}  // namespace
}  // namespace roomgraph::test
