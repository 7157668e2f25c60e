#include "roomgraph/align/WallPoint.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

Point along(double degrees) {
  return {std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180)};
}

TEST(OctantOf, countsLeftwardsFromTheXAxis) {
  for (int k = 0; k < kOctants; ++k)
    for (const double aside : {-22.4, -10.0, 0.0, 10.0, 22.4})
      EXPECT_EQ(octantOf(along(45 * k + aside)), k) << 45 * k + aside;
}

TEST(OctantOf, doesNotDependOnTheLength) {
  for (const double length : {1e-6, 1.0, 1e6}) EXPECT_EQ(octantOf(length * along(100)), 2);
}

}  // namespace
}  // namespace roomgraph
