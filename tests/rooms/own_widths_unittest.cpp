#include <gtest/gtest.h>

#include "plan.h"
#include "region_kinds.h"

namespace roomgraph::test {
namespace {

/** The own width of all that is free as one region. */
double widthOf(const Plan& plan, bool isWall = true) {
  const Inside inside = plan.inside();
  RegionGroups regions(inside.voronoi, inside.isInside, 0.15, 0.1);
  for (const std::uint32_t e : regions.edges())
    regions.join(inside.voronoi.edges[e].source, inside.voronoi.edges[e].target);
  const std::vector<std::uint8_t> walls(inside.voronoi.obstacles.size(), isWall ? 1 : 0);
  return ownWidths(regions,
                   walls)[regions.find(inside.voronoi.edges[regions.edges().front()].source)];
}

/** A corridor of 20 m x 1.8 m, and in its middle a square of so many cells. */
Plan corridor(int square) {
  const int above = square - 9, before = (100 - square) / 2;
  return Plan(100, square).wall(1, 1, before, above).wall(101 - before, 1, before, above);
}

TEST(OwnWidths, aCorridorHasItsWidthHoweverWideOneBayOfIt) {
  EXPECT_NEAR(widthOf(corridor(9)), 1.8, 0.01);
  EXPECT_NEAR(widthOf(corridor(17)), 1.8, 0.1) << "a bay of 3.4 m";
}

TEST(OwnWidths, aSquareHasThatOfItsLargestDisc) { EXPECT_NEAR(widthOf(Plan(25, 25)), 5, 0.2); }

TEST(OwnWidths, aHallWithACorridorHasThatOfItsLargestDisc) {
  EXPECT_GT(widthOf(corridor(60)), 11) << "12 m, and 4 m of corridor on two sides";
}

TEST(OwnWidths, theEdgeOfTheUnknownIsNoWall) { EXPECT_GT(widthOf(corridor(17), false), 3); }

}  // namespace
}  // namespace roomgraph::test
