#include "follow_corridors.h"

#include <gtest/gtest.h>

#include "plan.h"
#include "roomgraph/rooms/split_at_doors.h"

namespace roomgraph::test {
namespace {

Regions split(const Plan& plan) {
  const Inside inside = plan.inside();
  const std::vector<std::uint8_t> allWalls(inside.voronoi.obstacles.size(), 1);
  return splitAtDoors(inside.voronoi, inside.isInside, allWalls, 0.15, inside.grid,
                      SplitAtDoorsOptions());
}

/** A corridor of 1.8 m. In its middle 4 m of it are `wide` cells wide, behind doors of `door`. */
Plan stretch(int wide, int door) {
  const int above = wide - 9;
  return Plan(120, wide)
      .wall(1, 1, 49, above)
      .wall(71, 1, 50, above)
      .wall(50, 1, 1, wide)
      .gap(50, above + 1, 1, door)
      .wall(71, 1, 1, wide)
      .gap(71, above + 1, 1, door);
}

TEST(FollowCorridors, itGoesOnThroughAStretchBehindDoors) {
  // 1.2 or 1 m: with the former all is one piece, the latter is a door and bounds one.
  EXPECT_EQ(split(stretch(12, 6)).roomCount, 0u);
  EXPECT_EQ(split(stretch(12, 6)).count, 1u);
  EXPECT_EQ(split(stretch(12, 5)).roomCount, 0u);
}

TEST(FollowCorridors, aDoorInItsVeryMiddlePartsItThroughAThickWall) {
  // 2 m wide, 12 m long on each side of a wall of 0.4 m; the frame belongs to neither half.
  const Plan plan = Plan(122, 10).wall(61, 1, 2, 10);
  EXPECT_EQ(split(Plan(plan).gap(61, 4, 2, 5)).count, 2u);
  EXPECT_EQ(split(Plan(plan).gap(61, 2, 2, 8)).count, 1u);
}

TEST(FollowCorridors, aLobbyStandsOut) {
  EXPECT_EQ(split(stretch(18, 6)).roomCount, 1u) << "twice as wide";
  EXPECT_EQ(split(stretch(12, 3)).roomCount, 1u) << "doors as narrow as those of rooms";
}

/** A corridor of 1 m with so many cells of it 1.8 m wide, and 2 m of that on both sides behind
 *  openings of 1.2 m. */
Plan widening(int cells) {
  const int end = 101 + cells;
  return Plan(end + 100, 9)
      .wall(1, 1, 89, 4)
      .wall(end + 11, 1, 90, 4)
      .wall(100, 1, 1, 3)
      .wall(end, 1, 1, 3);
}

TEST(FollowCorridors, itGoesOnThroughALongStretchIntoWhichItOpensAsWideAsThatIs) {
  EXPECT_EQ(split(widening(26)).roomCount, 0u) << "5.2 m, wider than the corridor further on";
  EXPECT_EQ(split(widening(16)).roomCount, 1u) << "3.2 m: a lobby";
}

TEST(FollowCorridors, itGoesOnThroughSeveralStretches) {
  // Two of 4 m x 2.4 m, one behind the other, between 10 m of corridor each.
  Plan plan(141, 12);
  plan.wall(1, 1, 49, 3).wall(93, 1, 49, 3);
  for (const int door : {50, 71, 92}) plan.wall(door, 1, 1, 12).gap(door, 4, 1, 5);
  EXPECT_EQ(split(plan).roomCount, 0u);
}

TEST(FollowCorridors, itGoesOnRoundABendBehindDoors) {
  // Two arms of 16 m x 1.8 m, and a bend of 2.2 m square behind doors of 1 m.
  Plan bend(92, 92);
  bend.wall(1, 1, 83, 80).wall(1, 81, 80, 3);
  bend.wall(81, 82, 1, 11).gap(81, 85, 1, 5).wall(82, 81, 11, 1);
  EXPECT_EQ(split(bend.gap(85, 81, 5, 1)).roomCount, 0u);
}

TEST(FollowCorridors, aRoomWithTwoDoorsOnOneSideOfItIsNone) {
  // A corridor of 2 m, and a room as wide along it with two doors of 1.2 m into it.
  const Plan room = Plan(90, 21)
                        .wall(1, 11, 90, 1)
                        .wall(25, 12, 1, 10)
                        .wall(55, 12, 1, 10)
                        .gap(27, 11, 6, 1)
                        .gap(47, 11, 6, 1)
                        .wall(1, 12, 24, 10)
                        .wall(56, 12, 35, 10);
  EXPECT_EQ(split(room).roomCount, 1u);
  EXPECT_EQ(split(room).count, 2u);
}

TEST(FollowCorridors, itGoesOnBetweenPilasters) {
  // 2 m wide, with a pair of pilasters each 3 m that leave 1.4 m.
  const auto corridor = [](int pairs) {
    const int length = 16 * pairs + 15;
    Plan plan(length, 10);
    for (int pair = 1; pair <= pairs; ++pair)
      plan.wall(16 * pair, 1, 1, 10).gap(16 * pair, 3, 1, 7);
    return split(plan);
  };
  EXPECT_EQ(corridor(5).roomCount, 0u);
  EXPECT_EQ(corridor(5).count, 1u);
  EXPECT_EQ(corridor(1).roomCount, 2u) << "two rooms";
}

TEST(FollowCorridors, roomsInARowAreNoCorridorByThemselves) {
  // Three rooms of 5 m x 5 m, one behind the other, with doors of 2 m.
  const Plan row = Plan(77, 25).wall(26, 1, 1, 25).wall(52, 1, 1, 25);
  EXPECT_EQ(split(Plan(row).gap(26, 8, 1, 10).gap(52, 8, 1, 10)).roomCount, 3u);
}

}  // namespace
}  // namespace roomgraph::test
