#include "RegionGroups.h"

#include <gtest/gtest.h>

#include "plan.h"

namespace roomgraph::test {
namespace {

/** Four places in a row, with the narrowest one between the second and the third. */
VoronoiGraph row() {
  VoronoiGraph graph;
  graph.obstacles = {{0, 3}, {0, -3}};
  graph.vertices = {{{0, 0}, 3}, {{4, 0}, 2}, {{8, 0}, 2.5}, {{12, 0}, 1}};
  graph.edges = {{0, 1, 0, 1, 1.5},
                 {1, 2, 0, 1, 0.7},
                 {2, 3, 0, 1, 0.9},
                 {3, VoronoiEdge::kNoVertex, 0, 1, 0.9}};
  return graph;
}

using Edges = std::vector<std::uint32_t>;

TEST(RegionGroups, edgesRunFromWideToNarrow) {
  const VoronoiGraph graph = row();
  EXPECT_EQ(RegionGroups(graph, InsideFlags(4, 1), 0, 0).edges(), (Edges{0, 2, 1}));
}

TEST(RegionGroups, edgesAreWideEnoughAndInside) {
  const VoronoiGraph graph = row();
  EXPECT_EQ(RegionGroups(graph, InsideFlags(4, 1), 0.9, 0).edges(), (Edges{0, 2}));
  EXPECT_EQ(RegionGroups(graph, {1, 1, 1, 0}, 0, 0).edges(), (Edges{0, 1}));
}

TEST(RegionGroups, widthsAreFreeOfTheCells) {
  const VoronoiGraph graph = row();
  const InsideFlags all(4, 1);
  const RegionGroups regions(graph, all, 0, 0.8);
  EXPECT_DOUBLE_EQ(regions.radius(0), 2.2);
  EXPECT_DOUBLE_EQ(regions.clearance(graph.edges[0]), 0.7);
  EXPECT_EQ(regions.clearance(graph.edges[1]), 0) << "never below nothing";
}

TEST(RegionGroups, joinedRegionsHaveTheLargerDisc) {
  const VoronoiGraph graph = row();
  const InsideFlags all(4, 1);
  RegionGroups regions(graph, all, 0, 0);
  regions.join(3, 2);
  regions.join(1, 3);
  EXPECT_EQ(regions.find(1), regions.find(2));
  EXPECT_NE(regions.find(0), regions.find(1));
  EXPECT_DOUBLE_EQ(regions.radius(regions.find(3)), 2.5);
}

TEST(RegionGroups, neighboursMeetInTheWidestOfTheirPassages) {
  VoronoiGraph graph = row();
  graph.edges.push_back({0, 3, 0, 1, 1.2});
  const InsideFlags all(4, 1);
  RegionGroups regions(graph, all, 0, 0);
  regions.join(0, 1);
  regions.join(2, 3);
  const auto neighbours = regions.neighbours();
  ASSERT_EQ(neighbours.size(), 2u);
  EXPECT_EQ(neighbours[0].first, regions.find(0));
  ASSERT_EQ(neighbours[0].second.size(), 1u);
  const auto& [other, passage] = neighbours[0].second.front();
  EXPECT_EQ(other, regions.find(2));
  EXPECT_EQ(passage.count, 2);
  EXPECT_DOUBLE_EQ(passage.clearance, 1.2);
  EXPECT_EQ(regions.edges(), (Edges{4, 1})) << "those between different regions";
}

TEST(RegionGroups, bumpsChangeTheMeanWidthOfACorridorLessThanItsLargestDisc) {
  // 2 m wide; on one side a niche of 2 m x 2 m. A disc has 3 m there.
  const auto groupsOf = [](const Inside& inside) {
    RegionGroups regions(inside.voronoi, inside.isInside, 0.15, 0.1);
    for (const std::uint32_t e : regions.edges())
      regions.join(inside.voronoi.edges[e].source, inside.voronoi.edges[e].target);
    regions.sumAreas();
    regions.sumWalls(std::vector<std::uint8_t>(inside.voronoi.obstacles.size(), 1));
    const std::uint32_t all = regions.find(regions.voronoi().edges[regions.edges()[0]].source);
    return std::pair(2 * regions.radius(all), regions.meanWidth(all));
  };
  const auto [disc, mean] = groupsOf(Plan(100, 10).inside());
  const auto [wideDisc, wideMean] =
      groupsOf(Plan(100, 20).wall(1, 1, 100, 10).gap(50, 1, 10, 10).inside());
  EXPECT_GT(wideDisc, 1.2 * disc);
  EXPECT_LT(wideMean, 1.1 * mean);
}

TEST(RegionGroups, aSquareHasAnElongationOfOne) {
  // Wall cells stand half a cell outside of what is free.
  const Inside square = Plan(20, 20).inside(), corridor = Plan(80, 20).inside();
  const auto elongationOf = [](const Inside& inside) {
    RegionGroups regions(inside.voronoi, inside.isInside, 0, 0);
    for (const std::uint32_t e : Edges(regions.edges()))
      regions.join(inside.voronoi.edges[e].source, inside.voronoi.edges[e].target);
    regions.sumAreas();
    const auto first = std::find(inside.isInside.begin(), inside.isInside.end(), 1);
    return regions.elongation(regions.find(std::uint32_t(first - inside.isInside.begin())));
  };
  EXPECT_NEAR(elongationOf(square), 1, 0.02);
  EXPECT_NEAR(elongationOf(corridor), 81.0 / 21, 0.05);
}

TEST(RegionGroups, wallsCountByTheSpaceBesideThem) {
  // The left of two obstacles is wall: half of all space lies nearest to it.
  const VoronoiGraph graph = row();
  const InsideFlags all(4, 1);
  RegionGroups regions(graph, all, 0, 0);
  regions.sumWalls({1, 1});
  EXPECT_DOUBLE_EQ(regions.wallShare(1), 1);
  regions.sumWalls({1, 0});
  for (std::uint32_t v = 1; v < 4; ++v) EXPECT_DOUBLE_EQ(regions.wallShare(v), 1) << v;
  EXPECT_EQ(regions.wallShare(0), 0) << "lies where its edge is narrowest: all is its neighbour's";
  regions.sumWalls({0, 0});
  EXPECT_EQ(regions.wallShare(1), 0);
}

TEST(RegionGroups, roundingDecidesNothingInARightAngle) {
  // The first place is the middle between two walls, as often on a grid.
  for (const double rounding : {-1e-12, 1e-12}) {
    VoronoiGraph graph;
    graph.obstacles = {{0, 3}, {0, -3}, {-2, 3}, {-2, -3}};
    graph.vertices = {{{rounding, 0}, 3}, {{4, 0}, 5}, {{-4, 0}, 3.6}};
    graph.edges = {{0, 1, 0, 1, 3}, {0, 2, 3, 2, 3}};
    const InsideFlags all(3, 1);
    RegionGroups regions(graph, all, 0, 0);
    regions.sumWalls({1, 1, 0, 0});
    EXPECT_NEAR(regions.wallShare(0), 0, 1e-9);
    EXPECT_NEAR(regions.wallShare(1), 1, 1e-9);
    EXPECT_EQ(regions.wallShare(2), 0);
  }
}

}  // namespace
}  // namespace roomgraph::test
