#include "roomgraph/align/MapForAlignment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_building.h"

namespace roomgraph {
namespace {

TEST(MapForAlignment, octantsAreNearestMultiplesOf45Degrees) {
  for (int degrees = -180; degrees < 540; degrees += 5) {
    const double angle = (degrees + 0.1) * M_PI / 180;
    const int expected = int(std::lround(angle / M_PI_4) + 16) % 8;
    EXPECT_EQ(octantOf({std::cos(angle), std::sin(angle)}), expected) << degrees;
  }
}

TEST(MapForAlignment, wallsFaceTheFreeSpace) {
  const MapForAlignment map = mapForAlignment(test::squareHall({}), {});
  ASSERT_GT(map.walls.size(), 100u);
  for (const WallPoint& wall : map.walls) {
    const double far = std::max(std::abs(wall.place.x), std::abs(wall.place.y));
    const double outwards = dot(wall.place, wall.normal);
    EXPECT_TRUE(far > 3 ? outwards < 0 : outwards > 0) << wall.place.x << ", " << wall.place.y;
    EXPECT_NEAR(norm(wall.normal), 1, 1e-9);
  }
}

TEST(MapForAlignment, measuresTheFreeSpace) {
  const MapForAlignment map = mapForAlignment(test::squareHall({}), {});
  EXPECT_NEAR(map.freeArea, 11.8 * 11.8 - 4, 4);
  const Cell beside = map.frame.cellAt({3.5, 0});
  EXPECT_NEAR(map.depths[map.frame.index(beside)], 2.4, 0.3);
}

TEST(MapForAlignment, anEmptyMapHasNoWalls) {
  const MapForAlignment map = mapForAlignment(Grid{}, {});
  EXPECT_TRUE(map.walls.empty());
  EXPECT_EQ(map.freeArea, 0);
}

}  // namespace
}  // namespace roomgraph
