#include "roomgraph/topology/voronoi_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "Pose.h"
#include "drawn_obstacles.h"
#include "random_maps.h"
#include "roomgraph/geometry/Polyline.h"

namespace roomgraph::test {
namespace {

double nearestObstacle(const VoronoiGraph& graph, Point p) {
  double nearest = 1e300;
  for (const Point obstacle : graph.obstacles) nearest = std::min(nearest, distance(p, obstacle));
  return nearest;
}

TEST(VoronoiGraph, clearanceIsTheDistanceToTheNearestSite) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const VoronoiGraph graph = voronoiGraph(obstaclesOf(randomMap(seed, 24, 20, 0.1)));
    ASSERT_GT(graph.edges.size(), 0u);
    for (const VoronoiVertex& v : graph.vertices)
      EXPECT_NEAR(v.clearance, nearestObstacle(graph, v.place), 1e-9);
  }
}

TEST(VoronoiGraph, edgesLieBetweenTheirTwoNearestObstacles) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const VoronoiGraph graph = voronoiGraph(obstaclesOf(randomMap(seed, 24, 20, 0.1)));
    for (const VoronoiEdge& edge : graph.edges) {
      if (edge.isInfinite()) continue;
      const Point a = graph.vertices[edge.source].place, b = graph.vertices[edge.target].place;
      const Point left = graph.obstacles[edge.left], right = graph.obstacles[edge.right];
      double least = 1e300;
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Point p = a + t * (b - a);
        EXPECT_NEAR(distance(p, left), nearestObstacle(graph, p), 1e-9);
        EXPECT_NEAR(distance(p, right), nearestObstacle(graph, p), 1e-9);
        least = std::min(least, distance(p, left));
      }
      EXPECT_LE(edge.minClearance, least + 1e-12);
      EXPECT_NEAR(edge.minClearance, distanceToSegment(left, a, b), 1e-9);
      EXPECT_GT(cross(b - a, left - a), 0);
      EXPECT_LT(cross(b - a, right - a), 0);
    }
  }
}

TEST(VoronoiGraph, cellsOfASquareMeetInOneVertex) {
  const VoronoiGraph graph =
      voronoiGraph(obstaclesOf(drawn({"#...#", ".....", ".....", ".....", "#...#"}, 1)));
  ASSERT_EQ(graph.vertices.size(), 1u);
  EXPECT_NEAR(distance(graph.vertices[0].place, {2.5, 2.5}), 0, 1e-12);
  EXPECT_EQ(graph.edges.size(), 4u);
  for (const VoronoiEdge& edge : graph.edges) EXPECT_TRUE(edge.isInfinite());
}

TEST(VoronoiGraph, ofTooFewSitesHasNoEdge) {
  EXPECT_TRUE(voronoiGraph({{3, 3, 1, {}}, {}}).edges.empty());
  EXPECT_TRUE(voronoiGraph({{3, 3, 1, {}}, {{1, 1}}}).edges.empty());
  EXPECT_TRUE(voronoiGraph({{3, 3, 1, {}}, {{0, 1}, {1, 1}, {2, 1}}}).edges.empty());
}

/** Places and clearances of the vertices, rounded and sorted. */
std::vector<std::array<long, 3>> fingerprint(const VoronoiGraph& graph, const MapText& map,
                                             const Pose& pose, bool mapPlaces) {
  std::vector<std::array<long, 3>> vertices;
  for (const VoronoiVertex& v : graph.vertices) {
    const Point at = mapPlaces ? posed(v.place, map, pose) : v.place;
    vertices.push_back(
        {std::lround(at.x * 1e6), std::lround(at.y * 1e6), std::lround(v.clearance * 1e6)});
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

TEST(VoronoiGraph, isTheSameInAllEightPoses) {
  std::vector<MapText> maps{drawn({"########", "#......#", "#......#", "#..##..#", "#..##..#",
                                   "#......#", "#......#", "########"},
                                  0.25),
                            drawn({"#.#.#", ".....", "#.#.#", ".....", "#.#.#"}, 0.5)};
  for (std::uint32_t seed = 0; seed < 5; ++seed) maps.push_back(randomMap(seed, 24, 20, 0.125));
  for (const MapText& map : maps) {
    const VoronoiGraph reference = voronoiGraph(obstaclesOf(map));
    for (const Pose& pose : symmetries()) {
      const VoronoiGraph turned = voronoiGraph(obstaclesOf(posed(map, pose)));
      EXPECT_EQ(turned.edges.size(), reference.edges.size());
      EXPECT_EQ(fingerprint(turned, map, pose, false), fingerprint(reference, map, pose, true))
          << nameOf(pose);
    }
  }
}

}  // namespace
}  // namespace roomgraph::test
