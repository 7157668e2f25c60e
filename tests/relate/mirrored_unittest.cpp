#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_building.h"
#include "roomgraph/align/align_maps.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/relate/relate_maps.h"

namespace roomgraph {
namespace {

Grid mirroredGrid(Grid grid) {
  for (int y = 0; y < grid.frame.height; ++y) {
    const auto row = grid.cells.begin() + std::ptrdiff_t(grid.frame.index({0, y}));
    std::reverse(row, row + grid.frame.width);
  }
  grid.frame.origin.x = -(grid.frame.origin.x + grid.frame.width * grid.frame.resolution);
  return grid;
}

TEST(Mirrored, isTheMapOfTheMirroredPicture) {
  const Grid grid = test::drawnBuilding(3, {2, 1, 0.4});
  const WallMap image = mirrored(wallMap(grid)), drawn = wallMap(mirroredGrid(grid));
  const Alignment found = alignMaps(drawn, image);
  EXPECT_LT(distance(found.pose(image.middle()), image.middle()), 0.05);
  EXPECT_NEAR(found.pose.phi, 0, 0.002);
  EXPECT_GT(found.confidence, 0.9);
  EXPECT_FALSE(image.isBare());
  EXPECT_TRUE(mirrored(bareWallMap(grid)).isBare());
}

TEST(Mirrored, twiceIsTheMapItself) {
  const WallMap map = wallMap(test::drawnBuilding(3, {2, 1, 0.4}));
  const WallMap twice = mirrored(mirrored(map));
  EXPECT_EQ(twice.states, map.states);
  EXPECT_EQ(twice.walls.size(), map.walls.size());
  EXPECT_EQ(twice.turns, map.turns);
  EXPECT_EQ(twice.freeCells, map.freeCells);
  EXPECT_NEAR(twice.frame.origin.x, map.frame.origin.x, 1e-9);
}

TEST(Mirrored, wallsFaceTheOtherWay) {
  const WallMap map = wallMap(test::drawnBuilding(3, {}));
  const WallMap image = mirrored(map);
  for (std::size_t i = 0; i < map.walls.size(); i += 97) {
    const auto& [place, normal] = map.walls[i];
    const Point there{-place.x, place.y};
    const WallPoint* wall = nearestWall(image, there, {-normal.x, normal.y});
    ASSERT_TRUE(wall);
    EXPECT_LT(distance(wall->place, there), 0.1);
  }
}

}  // namespace
}  // namespace roomgraph
