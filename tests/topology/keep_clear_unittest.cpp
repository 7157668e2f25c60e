#include "roomgraph/topology/keep_clear.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_obstacles.h"
#include "random_maps.h"
#include "roomgraph/topology/voronoi_graph.h"

namespace roomgraph::test {
namespace {

TEST(KeepClear, keepsTheFiniteEdgesThatAreWideEnough) {
  const VoronoiGraph voronoi = voronoiGraph(obstaclesOf(randomMap(4, 40, 30, 0.1)));
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
  EXPECT_NEAR(effectiveClearance(options, 0.1), 0.075, 1e-8);
  options.minClearance = 0.3;
  EXPECT_NEAR(effectiveClearance(options, 0.1), 0.3, 1e-8);
}

/** A passage of just the least width is one wherever the map's origin is, though its clearance
 *  comes out a little more or less there. */
TEST(KeepClear, roundingDoesNotClosePassagesOfTheLeastWidth) {
  KeepClearOptions options;
  options.minClearance = 0.2;  // cells of 0.05 m make many passages of it
  const double clearance = effectiveClearance(options, 0.05);
  const auto keptAt = [&](Point origin) {
    MapText map = noisyOffice(4, 200);
    map.origin = origin;
    const VoronoiGraph voronoi = voronoiGraph(obstaclesOf(map));
    return keepClear(voronoi, InsideFlags(voronoi.vertices.size(), 1), clearance).size();
  };
  const std::size_t kept = keptAt({0, 0});
  EXPECT_GT(kept, 0u);
  for (const Point origin : {Point{0.7, 0.3}, {-12.34, 5.6}, {1.0 / 3, -100.1}, {33.3, 47.11}})
    EXPECT_EQ(keptAt(origin), kept) << origin.x;
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
