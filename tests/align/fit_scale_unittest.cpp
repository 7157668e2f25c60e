#include "roomgraph/align/fit_scale.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

/** The building's map as if its cells were smaller by `factor`. */
Grid shrunk(Grid grid, double factor) {
  grid.frame.resolution *= factor;
  grid.frame.origin = factor * grid.frame.origin;
  return grid;
}

TEST(FitScale, findsTheSizeOfTheCells) {
  const Grid building = test::drawnBuilding(5, {});
  const WallMap a = wallMap(building);
  for (const double factor : {0.98, 1.0, 1.03}) {
    const WallMap b = wallMap(shrunk(building, factor));
    // As if only the middle of the building were known to lie right.
    const Point middle{12, 8};
    const ScaledPose found = fitScale(a, b, carrying(factor * middle, middle, 0));
    EXPECT_NEAR(found.scale, 1 / factor, 0.002) << factor;
    EXPECT_LT(distance(found.pose((found.scale * factor) * middle), middle), 0.1) << factor;
  }
}

TEST(FitScale, whatIsOutOfReachStaysAsItIs) {
  const WallMap map = wallMap(test::drawnBuilding(5, {}));
  const ScaledPose found = fitScale(map, map, {500, 0, 0});
  EXPECT_EQ(found.scale, 1);
  EXPECT_EQ(found.pose.x, 500);
}

TEST(FitScale, theFramesOfTheMapsChangeNothing) {
  const Grid building = test::drawnBuilding(5, {});
  const Transform2D there{40, -20, 2};
  const WallMap a = wallMap(test::drawnBuilding(5, there));
  const WallMap b = wallMap(shrunk(building, 0.98));
  const Point middle{12, 8};
  const ScaledPose found = fitScale(a, b, carrying(0.98 * middle, there(middle), there.phi));
  EXPECT_NEAR(found.scale, 1 / 0.98, 0.002);
  EXPECT_LT(distance(found.pose((found.scale * 0.98) * middle), there(middle)), 0.1);
  EXPECT_NEAR(wrappedAngle(found.pose.phi - there.phi), 0, 0.01);
}

TEST(FitScale, swappingTheMapsGivesTheInverse) {
  const Grid building = test::drawnBuilding(5, {});
  const WallMap a = wallMap(building);
  const WallMap b = wallMap(shrunk(building, 0.97));
  const Point middle{12, 8};
  const ScaledPose forth = fitScale(a, b, carrying(0.97 * middle, middle, 0));
  const ScaledPose back = fitScale(b, a, carrying(middle, 0.97 * middle, 0));
  EXPECT_NEAR(forth.scale * back.scale, 1, 0.003);
}

TEST(FitScale, mapsOfOneSizeKeepIt) {
  const WallMap map = wallMap(test::drawnBuilding(5, {}));
  const ScaledPose found = fitScale(map, map, {});
  EXPECT_NEAR(found.scale, 1, 1e-6);
  EXPECT_NEAR(found.pose.x, 0, 1e-4);
}

TEST(FitScale, withoutWallsNothingMoves) {
  const WallMap map = wallMap(test::drawnBuilding(5, {}));
  const ScaledPose found = fitScale(map, wallMap(Grid{}), {1, 2, 3});
  EXPECT_EQ(found.scale, 1);
  EXPECT_EQ(found.pose.y, 2);
}

}  // namespace
}  // namespace roomgraph
