#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/clear_clutter.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph::test {
namespace {

/** A box round a place, turned [m]. */
struct Block {
  Point middle;
  double length, width, angle = 0;
};

/** A room of 12 x 9 m with walls of 0.2 m, drawn with cells of 0.05 m, and what stands in it. */
Grid roomWith(const std::vector<Block>& blocks) {
  Grid grid;
  grid.frame = {248, 188, 0.05, {-0.2, -0.2}};
  grid.cells.assign(grid.frame.cellCount(), State::free);
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) {
      const Point p = grid.frame.center({x, y});
      bool isSolid = p.x < 0 || p.x > 12 || p.y < 0 || p.y > 9;
      for (const Block& block : blocks) {
        const Point d = turned(p - block.middle, -block.angle);
        isSolid |= std::abs(d.x) < block.length / 2 && std::abs(d.y) < block.width / 2;
      }
      if (isSolid) grid.cells[grid.frame.index({x, y})] = State::occupied;
    }
  return grid;
}

ClearedMap cleared(const Grid& grid) {
  return clearClutter(grid, obstacleCells(grid, thinObstacles(grid, {}), false), {});
}

/** How much of it is furniture [m2]. */
double furnitureIn(const std::vector<Block>& blocks) {
  const Grid grid = roomWith(blocks);
  return double(cleared(grid).furniture.size()) * grid.frame.resolution * grid.frame.resolution;
}

TEST(FindFurniture, aShelfIsSomeHoweverItIsTurned) {
  for (int degrees = 0; degrees < 180; degrees += 17)
    EXPECT_NEAR(furnitureIn({{{6, 4.5}, 3, 0.8, degrees * M_PI / 180}}), 2.4, 0.2) << degrees;
}

TEST(FindFurniture, specksThatStickToAShelfDoNotMatter) {
  Grid grid = roomWith({{{6, 4.5}, 3, 0.8}});
  const auto draw = [&](int x, int y) { grid.cells[grid.frame.index({x, y})] = State::occupied; };
  for (int i = 0; i < 12; ++i) draw(110 + i, 102 + i), draw(130 - i, 84 - i);
  EXPECT_NEAR(double(cleared(grid).furniture.size()) * 0.05 * 0.05, 2.4, 0.2);
}

TEST(FindFurniture, piecesThatOnlyASpeckJoinsAreOneAlongEitherAxis) {
  for (const double angle : {0.0, M_PI / 2}) {
    const Point off = turned({0, 0.35}, angle);
    EXPECT_NEAR(furnitureIn({{Point{6, 4.5} + off, 1, 0.6, angle},
                             {Point{6, 4.5} - off, 1, 0.6, angle},
                             {{6.025, 4.525}, 0.04, 0.2, angle}}),
                1.2, 0.1)
        << angle;
  }
}

TEST(FindFurniture, whatIsThinLongOrNearIsNone) {
  EXPECT_EQ(furnitureIn({{{6, 4.5}, 3, 0.2}}), 0) << "a partition";
  EXPECT_EQ(furnitureIn({{{6, 4.5}, 6.5, 0.8}}), 0) << "longer than furniture";
  EXPECT_EQ(furnitureIn({{{6, 4.5}, 3, 2.6}}), 0) << "a block with rooms in it, perhaps";
  EXPECT_EQ(furnitureIn({{{6, 0.7}, 3, 0.8}}), 0) << "no robot passes between it and the wall";
  EXPECT_EQ(furnitureIn({{{6, 4}, 3, 0.8}, {{4.9, 5}, 0.8, 2.4}}), 0) << "an angle of two walls";
}

TEST(FindFurniture, aPierInLineWithAWallIsNone) {
  // Across the room, with openings of 1.2 m.
  const Block left{{1.5, 4.5}, 3, 0.4}, right{{10.5, 4.5}, 3, 0.4};
  EXPECT_EQ(furnitureIn({left, {{6, 4.5}, 3.6, 0.4}, right}), 0);
  EXPECT_GT(furnitureIn({left, {{6, 5.5}, 3.6, 0.4}, right}), 0) << "1 m out of line";
  EXPECT_GT(furnitureIn({left, {{6, 4.5}, 3.6, 1.6}, right}), 0) << "four times as thick";
  EXPECT_EQ(furnitureIn({left, {{5.1, 4.5}, 1.8, 0.4}, {{8.4, 4.5}, 2.4, 0.4}}), 0)
      << "in line with the first one";
}

TEST(FindFurniture, aSquarePierIsInLineWithTwoWallsInAnyDirection) {
  const Block pier{{6, 4.5}, 1.4, 1.4};
  EXPECT_EQ(furnitureIn({{{2.05, 4.5}, 4.1, 1.2}, pier}), 0);
  EXPECT_EQ(furnitureIn({{{6, 1.3}, 1.2, 2.6}, pier}), 0);
}

TEST(FindFurniture, endsAtTheBorderOfTheMap) {
  Grid grid;
  grid.frame = {80, 80, 0.05, {}};
  grid.cells.assign(grid.frame.cellCount(), State::free);
  for (int y = 0; y < 40; ++y)  // a triangle in the corner
    for (int x = 0; x < 40 - y; ++x) grid.cells[grid.frame.index({x + 1, y + 1})] = State::occupied;
  EXPECT_FALSE(cleared(grid).furniture.empty());
}

TEST(FindFurniture, aRowThatEndsAtTheFacesOfWallsIsSome) {
  EXPECT_NEAR(furnitureIn({{{2, 4.5}, 2, 0.8}, {{6, 4.5}, 3, 0.8}, {{10, 4.5}, 2, 0.8}}), 5.6, 0.3);
}

TEST(FindFurniture, staysInTheMapUntilItIsLeftOut) {
  const Grid grid = roomWith({{{6, 4.5}, 3, 0.8}});
  const ObstacleCells obstacles = obstacleCells(grid, thinObstacles(grid, {}), false);
  const ClearedMap map = clearClutter(grid, obstacles, {});
  EXPECT_TRUE(map.clutter.empty());
  EXPECT_EQ(map.grid.cells, grid.cells);
  const ClearedMap open = withoutFurniture(map, obstacles);
  EXPECT_EQ(open.grid.at({124, 94}), State::free);
  const auto countClutter = [](const ClearedMap& m) {
    return std::count(m.isClutter.begin(), m.isClutter.end(), 1);
  };
  EXPECT_EQ(countClutter(map), 0);
  EXPECT_GT(countClutter(open), 0);
}

}  // namespace
}  // namespace roomgraph::test
