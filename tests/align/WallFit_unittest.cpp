#include "roomgraph/align/WallFit.h"

#include <gtest/gtest.h>

#include "drawn_hall.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

/** Lays the walls of a hall that lies off by `pose` onto those of the hall itself. */
Transform2D laidFrom(const Transform2D& pose, int steps) {
  const WallMap map = wallMap(test::drawnHall(0.1, 0));
  Transform2D at = pose;
  for (int i = 0; i < steps; ++i) {
    WallFit fit(at, {4, 3}, 0.6);
    for (const WallPoint& wall : map.walls) fit.add(wall, map);
    EXPECT_TRUE(fit.isEnough());
    at = fit.improved(0.08);
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
  const WallMap map = wallMap(test::drawnHall(0.1, 0));
  WallFit fit({0.3, 0.2, 0}, {4, 3}, 0.6);
  for (const WallPoint& wall : map.walls)
    if (wall.normal.y > 0.99) fit.add(wall, map);
  ASSERT_TRUE(fit.isEnough());
  const Transform2D found = fit.improved(0.08);
  EXPECT_NEAR(found({4, 3}).x, 4.3, 0.01);
  EXPECT_LT(std::abs(found({4, 3}).y - 3), 0.1);
}

TEST(WallFit, withoutWallsThereIsNotEnough) {
  const WallMap map = wallMap(test::drawnHall(0.1, 0));
  WallFit fit({100, 0, 0}, {}, 0.6);
  for (const WallPoint& wall : map.walls) fit.add(wall, map);
  EXPECT_FALSE(fit.isEnough());
}

TEST(NarrowingBand, goesFromItsFirstWidthToItsLastByOneFactor) {
  const NarrowingBand band{0.8, 0.1, 4};
  EXPECT_DOUBLE_EQ(band.widthAt(0), 0.8);
  EXPECT_NEAR(band.widthAt(1), 0.4, 1e-12);
  EXPECT_NEAR(band.widthAt(2), 0.2, 1e-12);
  EXPECT_NEAR(band.widthAt(3), 0.1, 1e-12);
  EXPECT_DOUBLE_EQ((NarrowingBand{0.8, 0.1, 1}.widthAt(0)), 0.1) << "one step is the last one";
}

TEST(FittedPose, aBandThatNarrowsReachesFarAndFitsClosely) {
  const WallMap map = wallMap(test::drawnHall(0.1, 0));
  const auto all = [&](WallFit& fit, int) {
    for (const WallPoint& wall : map.walls) fit.add(wall, map);
  };
  const Point middle{4, 3};
  for (const Transform2D& start : {Transform2D{0.3, -0.2, 0.02}, Transform2D{-0.25, 0.3, -0.03}}) {
    const Transform2D found = fittedPose(start, middle, {0.8, 0.2, 5}, all);
    EXPECT_LT(distance(found(middle), middle), 0.03);
    EXPECT_NEAR(found.phi, 0, 0.01);
  }
}

TEST(FittedPose, staysWhereTooFewWallsAreInReach) {
  const WallMap map = wallMap(test::drawnHall(0.1, 0));
  int steps = 0;
  const Transform2D found =
      fittedPose({100, 0, 0.5}, {}, {0.8, 0.2, 5}, [&](WallFit& fit, int step) {
        EXPECT_EQ(step, steps++);
        for (const WallPoint& wall : map.walls) fit.add(wall, map);
      });
  EXPECT_EQ(found.x, 100);
  EXPECT_EQ(found.phi, 0.5);
  EXPECT_EQ(steps, 1) << "it gives up";
}

}  // namespace
}  // namespace roomgraph
