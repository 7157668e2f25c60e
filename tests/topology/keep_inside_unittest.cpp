#include "roomgraph/topology/keep_inside.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_obstacles.h"
#include "roomgraph/topology/voronoi_graph.h"

namespace roomgraph::test {
namespace {

class HouseOnWhite : public testing::Test {
 protected:
  // A house of 2 m with a wide hall in 0.1 m cells, white all round.
  HouseOnWhite() {
    std::vector<std::string> rows(60, std::string(60, '.'));
    for (std::size_t i = 20; i <= 40; ++i)
      rows[20][i] = rows[40][i] = rows[i][20] = rows[i][40] = '#';
    map_ = drawn(rows, 0.1);
    voronoi_ = voronoiGraph(obstaclesOf(map_));
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
    EXPECT_TRUE(!isInside[v] || isHouse(voronoi_.vertices[v].place));
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

TEST_F(HouseOnWhite, ofCoarseCellsIsNoLessInside) {
  MapText coarse = map_;
  for (const double resolution : {0.1, 1.0, 5.0}) {
    coarse.resolution = resolution;
    const InsideFlags isInside =
        keepInside(voronoiGraph(obstaclesOf(coarse)), gridOf(coarse), KeepInsideOptions());
    EXPECT_GT(std::count(isInside.begin(), isInside.end(), 1), 0) << resolution;
  }
}

TEST(KeepInside, leavesCellsThatAreNotFreeOut) {
  const MapText map =
      drawn({"#######", "#.....#", "#.....#", "#??...#", "#??...#", "#.....#", "#######"}, 1);
  const Grid grid = gridOf(map);
  ThinObstaclesOptions thin;
  thin.unknownIsObstacle = false;
  const VoronoiGraph voronoi = voronoiGraph(obstacleCells(grid, thinObstacles(grid, thin), false));
  KeepInsideOptions options;
  options.outsideWidth = 100;
  const InsideFlags freeOnly = keepInside(voronoi, grid, options);
  for (std::size_t v = 0; v < freeOnly.size(); ++v)
    EXPECT_TRUE(!freeOnly[v] || grid.isFree(voronoi.vertices[v].place));
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
  const VoronoiGraph voronoi = voronoiGraph(obstaclesOf(map));
  KeepInsideOptions options;
  options.outsideWidth = 2.4;
  options.biggestOnly = true;
  const InsideFlags isInside = keepInside(voronoi, gridOf(map), options);
  std::size_t count = 0;
  for (std::size_t v = 0; v < isInside.size(); ++v) {
    EXPECT_TRUE(!isInside[v] || voronoi.vertices[v].place.x > 5);
    count += isInside[v] != 0;
  }
  EXPECT_GT(count, 0u);
}

}  // namespace
}  // namespace roomgraph::test
