#include <gtest/gtest.h>

#include <cmath>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/clear_clutter.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph::test {
namespace {

constexpr double kDegree = M_PI / 180;

/** A box from a place on, along a direction; its width lies on both sides of that line [m]. */
struct Bar {
  Point from;
  double length, width, angle = 0;

  bool has(Point p) const {
    const Point d = turned(p - from, -angle);
    return d.x > 0 && d.x < length && std::abs(d.y) < width / 2;
  }
};

/** A corridor 2 m wide along x, in whose lower wall is a doorway from x = 0 to 0.9 m. */
std::vector<Bar> corridor() {
  return {{{-6, -0.1}, 6, 0.2}, {{0.9, -0.1}, 5.1, 0.2}, {{-6, 2.1}, 12, 0.2}};
}

/** A leaf at the left end of the doorway, opened so far; 0.85 m of it lie in the corridor. */
Bar leafAt(double degrees, double length = 0.85, double width = 0.05) {
  return {{-0.01, -0.1}, length + 0.1, width, degrees * kDegree};
}

Grid drawn(const std::vector<Bar>& bars, double turn = 0, double cell = 0.05) {
  Grid grid;
  const int side = int(14 / cell);
  grid.frame = {side, side, cell, {-7, -7}};
  grid.cells.assign(grid.frame.cellCount(), State::free);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Point p = turned(grid.frame.center({x, y}), -turn);
      for (const Bar& bar : bars)
        if (bar.has(p)) grid.cells[grid.frame.index({x, y})] = State::occupied;
    }
  return grid;
}

/** How many metres of leaves it has, if they are a cell thick. */
double leavesIn(const Grid& grid) {
  const auto map = clearClutter(grid, obstacleCells(grid, thinObstacles(grid, {}), false), {});
  return double(map.furniture.size()) * grid.frame.resolution;
}

std::vector<Bar> with(std::vector<Bar> bars, const Bar& more) {
  bars.push_back(more);
  return bars;
}

TEST(FindLeaves, anOpenLeafIsOneHoweverTheMapIsTurned) {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double leaves =
        leavesIn(drawn(with(corridor(), leafAt(90, 0.85, 0.08)), degrees * kDegree));
    EXPECT_GT(leaves, 0.8) << degrees;
    EXPECT_LT(leaves, 1.75) << degrees << ": two cells thick";
  }
}

TEST(FindLeaves, itMayLean) {
  for (const double degrees : {70, 80, 100, 110})
    EXPECT_GT(leavesIn(drawn(with(corridor(), leafAt(degrees)))), 0.6) << degrees;
}

TEST(FindLeaves, finerAndCoarserCellsTellItToo) {
  for (const double cell : {0.02, 0.1})
    EXPECT_GT(leavesIn(drawn(with(corridor(), leafAt(90, 0.85, 0.1)), 0, cell)), 0.6) << cell;
}

TEST(FindLeaves, whatHasNoDoorwayOfItsWidthIsNone) {
  EXPECT_EQ(leavesIn(drawn(corridor())), 0);
  EXPECT_EQ(leavesIn(drawn(with(corridor(), {{-3, 0}, 0.85, 0.05, 90 * kDegree}))), 0)
      << "on a wall without a door";
  EXPECT_EQ(leavesIn(drawn({{{-6, -0.1}, 6, 0.2}, {{2, -0.1}, 4, 0.2}, leafAt(90)})), 0)
      << "an opening of 2 m";
  EXPECT_EQ(leavesIn(drawn(with(corridor(), leafAt(90, 1.5)))), 0) << "too long";
  EXPECT_EQ(leavesIn(drawn(with(corridor(), leafAt(90, 0.85, 0.3)))), 0) << "too thick";
  EXPECT_EQ(leavesIn(drawn({{{-6, -0.1}, 6, 0.2}, leafAt(90)})), 0) << "the end of a wall";
}

TEST(FindLeaves, aPieceOfWallBesideADoorwayIsNone) {
  // The wall of a bath: 0.85 m, its door, and more of it.
  EXPECT_EQ(leavesIn(drawn(with(with(corridor(), leafAt(90, 0.85, 0.1)),
                                {{-0.01, 1.6}, 0.5, 0.1, 90 * kDegree}))),
            0);
}

TEST(FindLeaves, aWallThatEndsInACorridorIsNone) {
  // Between a door in the wall of a corridor 1.1 m wide and the next wall across that.
  EXPECT_EQ(leavesIn(drawn({{{0, -3}, 6, 0.2, 90 * kDegree},
                            {{-1.1, -3}, 6, 0.2, 90 * kDegree},
                            {{0, 0}, 0.9, 0.1},
                            {{0.9, -3}, 6, 0.1, 90 * kDegree}})),
            0);
}

}  // namespace
}  // namespace roomgraph::test
