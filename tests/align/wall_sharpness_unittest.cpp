#include "wall_sharpness.h"

#include <gtest/gtest.h>

#include "drawn_hall.h"

namespace roomgraph {
namespace {

TEST(WallSharpness, isTheThicknessInCellsWhereAllEndsAtWalls) {
  EXPECT_NEAR(wallSharpness(test::drawnHall(0.05, 0)).value(), 1, 0.03);
  EXPECT_NEAR(wallSharpness(test::drawnHall(0.1, 0)).value(), 2, 0.1);
}

TEST(WallSharpness, anEdgeWithoutWallLowersIt) {
  Grid frayed = test::drawnHall(0.05, 0);
  for (int y = 0; y < frayed.frame.height; ++y)  // the east wall was never drawn
    for (int x = 0; x < frayed.frame.width; ++x)
      if (frayed.frame.center({x, y}).x > 8)
        frayed.cells[frayed.frame.index({x, y})] = State::unknown;
  EXPECT_NEAR(wallSharpness(frayed).value(), 22.0 / 28, 0.03);
}

TEST(WallSharpness, whatLiesDeepInAWallIsNotSeenAsWall) {
  EXPECT_NEAR(wallSharpness(test::drawnHall(0.6, 0)).value(),
              wallSharpness(test::drawnHall(0.9, 0)).value(), 1e-9);
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
