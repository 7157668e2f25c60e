#include "find_fronts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan.h"

namespace roomgraph::test {
namespace {

/** The places of all fronts: from the middle of each into its cubicle, a cell on. */
std::vector<Point> frontsIn(const Plan& plan) {
  const Inside inside = plan.inside();
  const VoronoiGraph& voronoi = inside.voronoi;
  const RegionGroups regions(voronoi, inside.isInside, 0.15, 0.1);
  const std::vector<CubicleEnd> sides = findFronts(regions, inside.grid);
  std::vector<Point> fronts;
  for (std::size_t e = 0; e < sides.size(); ++e) {
    if (sides[e] == CubicleEnd::none) continue;
    const VoronoiEdge& edge = voronoi.edges[e];
    const Point middle = midpoint(voronoi.obstacles[edge.left], voronoi.obstacles[edge.right]);
    const Point way = voronoi.vertices[edge.target].place - voronoi.vertices[edge.source].place;
    const double sign = sides[e] == CubicleEnd::target ? 0.2 : -0.2;
    fronts.push_back(middle + sign / norm(way) * way);
  }
  std::sort(fronts.begin(), fronts.end());
  return fronts;
}

/** Two cubicles, 2.6 m long and 2 m deep, on an aisle of 1.6 m; their fronts are 2 m wide. */
Plan cubicles() {
  Plan plan(41, 19);
  plan.wall(1, 9, 41, 1).wall(14, 10, 1, 10).wall(28, 10, 1, 10);
  return plan.gap(4, 9, 10, 1).gap(18, 9, 10, 1);
}

TEST(FindFronts, partitionsAndStubsOfWallMakeOne) {
  const Plan plan = cubicles();
  const std::vector<Point> fronts = frontsIn(plan);
  ASSERT_EQ(fronts.size(), 2u);
  EXPECT_NEAR(distance(fronts[0] + Point{2.8, 0}, fronts[1]), 0, 1e-9);
  const double wall = plan.inside().grid.frame.center({0, 11}).y;
  EXPECT_NEAR(fronts[0].y, wall - 0.2, 1e-9) << "the cubicles are below the aisle";
}

TEST(FindFronts, noneIsAsLongAsWhatLiesBehind) {
  EXPECT_TRUE(frontsIn(cubicles().gap(1, 9, 13, 1).gap(15, 9, 13, 1)).empty());
}

TEST(FindFronts, noneIsAsNarrowAsADoor) {
  EXPECT_TRUE(frontsIn(cubicles().wall(1, 9, 7, 1).wall(15, 9, 7, 1)).empty());
}

TEST(FindFronts, halvesOfARoomAreNoCubicles) {
  EXPECT_TRUE(frontsIn(Plan(41, 20).wall(21, 1, 1, 20).gap(21, 5, 1, 12)).empty());
}

TEST(FindFronts, norAreSpacesBetweenShelves) {
  Plan hall(60, 40);
  for (const int x : {11, 26, 41}) hall.wall(x, 1, 5, 12).wall(x, 29, 5, 12);
  EXPECT_TRUE(frontsIn(hall).empty());
}

TEST(FindFronts, aStraightWallIsNoCorner) {
  EXPECT_TRUE(frontsIn(Plan(41, 20).wall(21, 1, 1, 8)).empty());
}

}  // namespace
}  // namespace roomgraph::test
