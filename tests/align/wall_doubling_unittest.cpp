#include "roomgraph/align/wall_doubling.h"

#include <gtest/gtest.h>

#include <functional>

#include "drawn_building.h"
#include "wall_sharpness.h"

namespace roomgraph {
namespace {

/** A hall of 8 m by 6 m, walls of `thickness`, and a line of wall `gap` in front of its south wall
 *  from x = 1 to x = 5. */
Grid hall(double thickness, double gap) {
  Grid grid;
  grid.frame = {200, 160, 0.05, {-1, -1}};
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) {
      const Point p = grid.frame.center({x, y});
      const bool isIn = p.x > 0 && p.x < 8 && p.y > 0 && p.y < 6;
      const bool isNear =
          p.x > -thickness && p.x < 8 + thickness && p.y > -thickness && p.y < 6 + thickness;
      const bool isCopy = p.x > 1 && p.x < 5 && p.y > gap && p.y < gap + 0.1;
      grid.cells.push_back(isIn     ? (gap > 0 && isCopy ? State::occupied : State::free)
                           : isNear ? State::occupied
                                    : State::unknown);
    }
  return grid;
}

double doublingOf(const Grid& grid) { return wallDoubling(mapForAlignment(grid, {})).value(); }

TEST(WallDoubling, aSoundMapHasNearlyNone) {
  EXPECT_LT(doublingOf(hall(0.1, 0)), 0.01);
  EXPECT_LT(doublingOf(test::drawnBuilding(1, {3, 4, 0.3})), 0.03) << "thin walls with two sides";
}

TEST(WallDoubling, aCopyOfAWallCountsWithTheWall) {
  // 4 m of the wall's 28 m are there twice; the copy has a back, too.
  const double twice = doublingOf(hall(0.1, 0.4));
  EXPECT_GT(twice, 0.16);
  EXPECT_LT(twice, 0.28);
}

TEST(WallDoubling, aWallFartherAwayIsAnotherOne) { EXPECT_LT(doublingOf(hall(0.1, 1.5)), 0.02); }

TEST(WallDoubling, aMapWithoutWallsHasNone) {
  EXPECT_FALSE(wallDoubling(mapForAlignment(Grid{}, {})));
}

TEST(WallSharpness, isTheThicknessInCellsWhereAllEndsAtWalls) {
  EXPECT_NEAR(wallSharpness(hall(0.05, 0)).value(), 1, 0.03);
  EXPECT_NEAR(wallSharpness(hall(0.1, 0)).value(), 2, 0.1);
}

TEST(WallSharpness, anEdgeWithoutWallLowersIt) {
  Grid frayed = hall(0.05, 0);
  for (int y = 0; y < frayed.frame.height; ++y)  // the east wall was never drawn
    for (int x = 0; x < frayed.frame.width; ++x)
      if (frayed.frame.center({x, y}).x > 8)
        frayed.cells[frayed.frame.index({x, y})] = State::unknown;
  EXPECT_NEAR(wallSharpness(frayed).value(), 22.0 / 28, 0.03);
}

TEST(WallSharpness, whatLiesDeepInAWallIsNotSeenAsWall) {
  EXPECT_NEAR(wallSharpness(hall(0.6, 0)).value(), wallSharpness(hall(0.9, 0)).value(), 1e-9);
}

TEST(WallSharpness, aMapWithoutWallsHasNone) {
  EXPECT_FALSE(wallSharpness(Grid{}));
  Grid free;
  free.frame = {2, 2, 0.05, {}};
  free.cells.assign(4, State::free);
  EXPECT_FALSE(wallSharpness(free));
}

}  // namespace
}  // namespace roomgraph
