#include "find_halls.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan.h"
#include "roomgraph/rooms/split_at_doors.h"

namespace roomgraph::test {
namespace {

/** How many regions of a plan would be halls if all were corridor. */
int hallsOf(const Plan& plan) {
  const Inside inside = plan.inside();
  const std::vector<std::uint8_t> allWalls(inside.voronoi.obstacles.size(), 1);
  SplitAtDoorsOptions options;
  Regions regions =
      splitAtDoors(inside.voronoi, inside.isInside, allWalls, 0.15, inside.grid, options);
  regions.roomCount = 0;
  const std::vector<std::uint8_t> isHall = findHalls(inside.voronoi, regions, options);
  EXPECT_EQ(isHall.size(), regions.count);
  return int(std::count(isHall.begin(), isHall.end(), 1));
}

TEST(FindHalls, severalShelvesStandInOne) {
  EXPECT_EQ(hallsOf(Plan(60, 40).wall(10, 8, 4, 26).wall(28, 8, 4, 26).wall(46, 8, 4, 26)), 1);
}

TEST(FindHalls, roundOneIslandIsACorridor) {
  EXPECT_EQ(hallsOf(Plan(60, 40).wall(10, 8, 4, 26)), 0);
}

TEST(FindHalls, islandsThatAreLargerThanTheFloorAreBlocks) {
  EXPECT_EQ(hallsOf(Plan(100, 60).wall(7, 7, 40, 46).wall(54, 7, 40, 46)), 0);
}

TEST(FindHalls, islandsThatAreWiderThanTheAislesAreBlocksThoughTheFloorIsLarger) {
  EXPECT_EQ(hallsOf(Plan(90, 50).wall(10, 10, 30, 30).wall(50, 10, 30, 30)), 0);
}

TEST(FindHalls, aLongCorridorWithBenchesIsNone) {
  EXPECT_EQ(hallsOf(Plan(200, 16).wall(40, 7, 8, 3).wall(140, 7, 8, 3)), 0);
}

TEST(FindHalls, anIslandWithARoomInItDoesNotCount) {
  const auto withRoom = [](bool isThere) {
    Plan plan = Plan(120, 70).wall(20, 20, 4, 30).wall(62, 20, 24, 30);
    return isThere ? plan.gap(65, 23, 18, 24) : plan;
  };
  EXPECT_EQ(hallsOf(withRoom(false)), 1);
  EXPECT_EQ(hallsOf(withRoom(true)), 0);
}

TEST(FindHalls, whatStandsBetweenBlocksWithRoomsIsNoShelf) {
  Plan plan(230, 180);
  for (const int x : {30, 130})
    for (const int y : {30, 105}) plan.wall(x, y, 70, 45).gap(x + 3, y + 3, 64, 39);
  EXPECT_EQ(hallsOf(plan.wall(110, 88, 2, 6).wall(120, 88, 2, 6)), 0);
}

}  // namespace
}  // namespace roomgraph::test
