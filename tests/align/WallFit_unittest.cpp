#include "roomgraph/align/WallFit.h"

#include <gtest/gtest.h>

#include "drawn_hall.h"

namespace roomgraph {
namespace {

/** Lays the walls of a hall that lies off by `pose` onto those of the hall itself. */
Transform2D laidFrom(const Transform2D& pose, int steps) {
  const MapForAlignment map = mapForAlignment(test::drawnHall(0.1, 0), {});
  Transform2D at = pose;
  for (int i = 0; i < steps; ++i) {
    WallFit fit(at, {4, 3}, 0.6);
    for (const WallPoint& wall : map.walls) fit.add(wall, map);
    EXPECT_TRUE(fit.isEnough());
    at = fit.improved();
  }
  return at;
}

TEST(WallFit, oneStepBringsWallsNearer) {
  const Transform2D once = laidFrom({0.3, -0.2, 0.02}, 1);
  EXPECT_LT(norm(once.shift()), norm(Point{0.3, -0.2}));
}

TEST(WallFit, manyStepsBringThemOntoEachOther) {
  const Transform2D found = laidFrom({0.3, -0.2, 0.02}, 10);
  EXPECT_LT(distance(found({4, 3}), {4, 3}), 0.02);
  EXPECT_NEAR(found.phi, 0, 0.005);
}

TEST(WallFit, wallsThatLieRightStay) {
  const Transform2D found = laidFrom({}, 1);
  EXPECT_LT(norm(found.shift()), 1e-5) << "some are looked up a little aside";
  EXPECT_NEAR(found.phi, 0, 1e-5);
}

TEST(WallFit, whatNoWallHoldsStaysAsItIs) {
  // South walls alone hold neither x nor, much, the turn.
  const MapForAlignment map = mapForAlignment(test::drawnHall(0.1, 0), {});
  WallFit fit({0.3, 0.2, 0}, {4, 3}, 0.6);
  for (const WallPoint& wall : map.walls)
    if (wall.normal.y > 0.99) fit.add(wall, map);
  ASSERT_TRUE(fit.isEnough());
  const Transform2D found = fit.improved();
  EXPECT_NEAR(found({4, 3}).x, 4.3, 0.01);
  EXPECT_LT(std::abs(found({4, 3}).y - 3), 0.1);
}

TEST(WallFit, withoutWallsThereIsNotEnough) {
  const MapForAlignment map = mapForAlignment(test::drawnHall(0.1, 0), {});
  WallFit fit({100, 0, 0}, {}, 0.6);
  for (const WallPoint& wall : map.walls) fit.add(wall, map);
  EXPECT_FALSE(fit.isEnough());
}

}  // namespace
}  // namespace roomgraph
