#include "roomgraph/topology/face_areas.h"

#include <gtest/gtest.h>

#include <numeric>

#include "drawn_obstacles.h"
#include "random_maps.h"
#include "roomgraph/topology/voronoi_graph.h"

namespace roomgraph::test {
namespace {

TEST(FaceAreas, ofAllGroupsAreTheHullOfTheObstacles) {
  const VoronoiGraph graph =
      voronoiGraph(obstaclesOf(drawn({"#...#", ".....", "..#..", ".....", "#...#"}, 0.5)));
  const auto areas = faceAreas(graph, [](std::uint32_t v) { return v; });
  EXPECT_EQ(areas.size(), graph.vertices.size());
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 4, 1e-12) << "2 m by 2 m";
  for (const double area : areas) EXPECT_NEAR(area, 1, 1e-12) << "a quarter each";
}

TEST(FaceAreas, ofAGroupIsTheSumOfItsFaces) {
  const VoronoiGraph graph = voronoiGraph(obstaclesOf(randomMap(7, 30, 20, 0.1)));
  const auto single = faceAreas(graph, [](std::uint32_t v) { return v; });
  const auto halves = faceAreas(graph, [](std::uint32_t v) { return v % 2; });
  double even = 0;
  for (std::size_t v = 0; v < single.size(); v += 2) even += single[v];
  EXPECT_NEAR(halves[0], even, 1e-9);
}

TEST(FaceAreas, whatIsInNoGroupDoesNotCount) {
  const VoronoiGraph graph = voronoiGraph(obstaclesOf(randomMap(7, 30, 20, 0.1)));
  const auto none = faceAreas(graph, [](std::uint32_t) { return VoronoiEdge::kNoVertex; });
  EXPECT_EQ(std::count(none.begin(), none.end(), 0.0), std::ptrdiff_t(none.size()));
}

}  // namespace
}  // namespace roomgraph::test
