#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "Pose.h"
#include "random_maps.h"
#include "roomgraph/geometry/Polyline.h"
#include "roomgraph/grid/thin_obstacles.h"
#include "roomgraph/voronoi/keep_clear.h"
#include "roomgraph/voronoi/keep_inside.h"
#include "roomgraph/voronoi/voronoi_graph.h"

namespace roomgraph::test {
namespace {

ObstacleSites sitesOf(const MapText& map) {
  const Grid grid = gridOf(map);
  return obstacleSites(grid, thinObstacles(grid, {}), hasUnknown(map));
}

double nearestSite(const VoronoiGraph& graph, Point p) {
  double nearest = 1e300;
  for (const Point site : graph.sites) nearest = std::min(nearest, distance(p, site));
  return nearest;
}

TEST(VoronoiGraph, clearanceIsTheDistanceToTheNearestSite) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const VoronoiGraph graph = voronoiGraph(sitesOf(randomMap(seed, 24, 20, 0.1)));
    ASSERT_GT(graph.edges.size(), 0u);
    for (const VoronoiVertex& v : graph.vertices)
      EXPECT_NEAR(v.clearance, nearestSite(graph, v.at), 1e-9);
  }
}

TEST(VoronoiGraph, edgesLieBetweenTheirTwoNearestSites) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const VoronoiGraph graph = voronoiGraph(sitesOf(randomMap(seed, 24, 20, 0.1)));
    for (const VoronoiEdge& edge : graph.edges) {
      if (edge.isInfinite()) continue;
      const Point a = graph.vertices[edge.source].at, b = graph.vertices[edge.target].at;
      const Point left = graph.sites[edge.left], right = graph.sites[edge.right];
      double least = 1e300;
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Point p = a + t * (b - a);
        EXPECT_NEAR(distance(p, left), nearestSite(graph, p), 1e-9);
        EXPECT_NEAR(distance(p, right), nearestSite(graph, p), 1e-9);
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
      voronoiGraph(sitesOf(drawn({"#...#", ".....", ".....", ".....", "#...#"}, 1)));
  ASSERT_EQ(graph.vertices.size(), 1u);
  EXPECT_NEAR(distance(graph.vertices[0].at, {2.5, 2.5}), 0, 1e-12);
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
    const Point at = mapPlaces ? posed(v.at, map, pose) : v.at;
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
    const VoronoiGraph reference = voronoiGraph(sitesOf(map));
    for (const Pose& pose : symmetries()) {
      const VoronoiGraph turned = voronoiGraph(sitesOf(posed(map, pose)));
      EXPECT_EQ(turned.edges.size(), reference.edges.size());
      EXPECT_EQ(fingerprint(turned, map, pose, false), fingerprint(reference, map, pose, true))
          << nameOf(pose);
    }
  }
}

class HouseOnWhite : public testing::Test {
 protected:
  // A house of 2 m with a wide hall in 0.1 m cells, white all round.
  HouseOnWhite() {
    std::vector<std::string> rows(60, std::string(60, '.'));
    for (std::size_t i = 20; i <= 40; ++i)
      rows[20][i] = rows[40][i] = rows[i][20] = rows[i][40] = '#';
    map_ = drawn(rows, 0.1);
    voronoi_ = voronoiGraph(sitesOf(map_));
  }

  bool isHouse(Point p) const { return p.x > 2 && p.x < 4.1 && p.y > 1.9 && p.y < 4; }

  MapText map_;
  VoronoiGraph voronoi_;
};

TEST_F(HouseOnWhite, outsideIsLeftOut) {
  KeepInsideOptions options;
  options.outsideWidth = 3;
  const InsideFlags isInside = keepInside(voronoi_, gridOf(map_), options);
  std::size_t count = 0;
  for (std::size_t v = 0; v < isInside.size(); ++v) {
    EXPECT_TRUE(!isInside[v] || isHouse(voronoi_.vertices[v].at));
    count += isInside[v] != 0;
  }
  EXPECT_GT(count, 0u);
}

TEST_F(HouseOnWhite, aSmallDiscOutsideDoesNotPassTheWall) {
  KeepInsideOptions options;
  options.outsideWidth = 0.5;
  const InsideFlags isInside = keepInside(voronoi_, gridOf(map_), options);
  EXPECT_GT(std::count(isInside.begin(), isInside.end(), 1), 0);
}

TEST(KeepInside, leavesCellsThatAreNotFreeOut) {
  const MapText map =
      drawn({"#######", "#.....#", "#.....#", "#??...#", "#??...#", "#.....#", "#######"}, 1);
  const Grid grid = gridOf(map);
  ThinObstaclesOptions thin;
  thin.unknownIsObstacle = false;
  const VoronoiGraph voronoi = voronoiGraph(obstacleSites(grid, thinObstacles(grid, thin), false));
  KeepInsideOptions options;
  options.outsideWidth = 100;
  const InsideFlags freeOnly = keepInside(voronoi, grid, options);
  for (std::size_t v = 0; v < freeOnly.size(); ++v)
    EXPECT_TRUE(!freeOnly[v] || grid.isFree(voronoi.vertices[v].at));
  options.freeOnly = false;
  const InsideFlags all = keepInside(voronoi, grid, options);
  EXPECT_GT(std::count(all.begin(), all.end(), 1), std::count(freeOnly.begin(), freeOnly.end(), 1));
}

TEST(KeepInside, biggestOnlyKeepsOnePolygon) {
  std::vector<std::string> rows(30, std::string(80, '.'));
  const auto box = [&](std::size_t x, std::size_t y, std::size_t w, std::size_t h) {
    for (std::size_t i = 0; i < w; ++i) rows[y][x + i] = rows[y + h - 1][x + i] = '#';
    for (std::size_t i = 0; i < h; ++i) rows[y + i][x] = rows[y + i][x + w - 1] = '#';
  };
  box(5, 5, 12, 12);
  box(50, 5, 20, 20);
  const MapText map = drawn(rows, 0.1);
  const VoronoiGraph voronoi = voronoiGraph(sitesOf(map));
  KeepInsideOptions options;
  options.outsideWidth = 2.4;
  options.biggestOnly = true;
  const InsideFlags isInside = keepInside(voronoi, gridOf(map), options);
  std::size_t count = 0;
  for (std::size_t v = 0; v < isInside.size(); ++v) {
    EXPECT_TRUE(!isInside[v] || voronoi.vertices[v].at.x > 5);
    count += isInside[v] != 0;
  }
  EXPECT_GT(count, 0u);
}

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

}  // namespace
}  // namespace roomgraph::test
