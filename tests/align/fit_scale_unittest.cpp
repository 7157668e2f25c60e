#include "roomgraph/align/fit_scale.h"

#include <gtest/gtest.h>

#include "drawn_building.h"

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
  const MapForAlignment a = mapForAlignment(building, {});
  for (const double factor : {0.98, 1.0, 1.03}) {
    const MapForAlignment b = mapForAlignment(shrunk(building, factor), {});
    // As if only the middle of the building were known to lie right.
    const Point middle{12, 8};
    const ScaledPose found = fitScale(a, b, carrying(factor * middle, middle, 0), {});
    EXPECT_NEAR(found.scale, 1 / factor, 0.002) << factor;
    EXPECT_LT(distance(found.pose((found.scale * factor) * middle), middle), 0.1) << factor;
  }
}

TEST(FitScale, whatIsOutOfReachStaysAsItIs) {
  const MapForAlignment map = mapForAlignment(test::drawnBuilding(5, {}), {});
  const ScaledPose found = fitScale(map, map, {500, 0, 0}, {});
  EXPECT_EQ(found.scale, 1);
  EXPECT_EQ(found.pose.x, 500);
}

}  // namespace
}  // namespace roomgraph
