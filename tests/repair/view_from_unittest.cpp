#include "roomgraph/repair/view_from.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

/** Two rooms of 6 m beside each other, with a wall between, from (0, 0) on. */
WallMap twoRooms() {
  Grid grid;
  grid.frame = {261, 141, 0.05, {-0.5, -0.5}};
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) {
      const Point p = grid.frame.center({x, y});
      const bool isInside = p.y > 0 && p.y < 6 && p.x > 0 && p.x < 12;
      const bool isWall = p.x > 5.9 && p.x < 6.1;
      const bool isNear = p.y > -0.2 && p.y < 6.2 && p.x > -0.2 && p.x < 12.2;
      grid.cells.push_back(isInside && !isWall ? State::free
                           : isNear            ? State::occupied
                                               : State::unknown);
    }
  return wallMap(grid);
}

TEST(ViewFrom, wallsOfTheRoomAreSeenAndNoneBehindThem) {
  const WallMap map = twoRooms();
  const LocalScan view = viewFrom(map, {3, 3, 0}, 12);
  ASSERT_TRUE(view.isTelling());
  for (const WallPoint& wall : view.walls) {
    EXPECT_LT(std::max(std::abs(wall.place.x), std::abs(wall.place.y)), 3.2);
    EXPECT_LT(dot(wall.normal, wall.place), 0) << "it faces the place";
  }
  EXPECT_LT(viewFrom(map, {3, 3, 0}, 3.5).walls.size(), view.walls.size());
}

TEST(ViewFrom, isInTheFrameOfThePlace) {
  const WallMap map = twoRooms();
  const LocalScan straight = viewFrom(map, {1, 2, 0}, 12), turned = viewFrom(map, {1, 2, 2}, 12);
  ASSERT_EQ(straight.walls.size(), turned.walls.size());
  const Motion2D back(Transform2D{0, 0, -2});
  for (std::size_t i = 0; i < turned.walls.size(); ++i)
    EXPECT_LT(distance(back(straight.walls[i].place), turned.walls[i].place), 1e-9);
}

TEST(ViewFrom, nothingIsSeenOutsideOfTheMap) {
  EXPECT_TRUE(viewFrom(twoRooms(), {500, 0, 0}, 12).walls.empty());
  EXPECT_TRUE(viewFrom(WallMap{}, {}, 12).walls.empty());
}

}  // namespace
}  // namespace roomgraph
