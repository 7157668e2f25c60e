#include "roomgraph/rooms/find_rooms.h"

#include <gtest/gtest.h>

#include "plan.h"

namespace roomgraph::test {
namespace {

Regions regionsOf(const MapText& map, double radius) { return DividedByDisc(map, radius).regions; }

TEST(FindRooms, aCorridorIsNotARoom) {
  const MapText map = drawn(
      {"#############", "#############", "#...........#", "#...........#", "#############"}, 1);
  EXPECT_EQ(regionsOf(map, 2).roomCount, 0u);
  EXPECT_EQ(regionsOf(map, 1.2).roomCount, 1u);
}

/** Two rooms 6 m wide, and a corridor of 2 m between them. */
MapText twoRoomsOnACorridor() {
  return drawn({"#######################", "#......#########......#", "#......#########......#",
                "#.....................#", "#......#########......#", "#......#########......#",
                "#######################"},
               1);
}

TEST(FindRooms, aWayTooNarrowForTheDiscPartsTwoRooms) {
  const Regions regions = regionsOf(twoRoomsOnACorridor(), 2);
  EXPECT_EQ(regions.roomCount, 2u);
  EXPECT_EQ(regions.radius, 2);
  EXPECT_EQ(regionsOf(twoRoomsOnACorridor(), 0.9).roomCount, 1u) << "the disc fits through";
}

TEST(FindRooms, whatIsInNoRoomIsCorridorInPiecesThatADiscPasses) {
  const Regions regions = regionsOf(twoRoomsOnACorridor(), 2);
  ASSERT_GT(regions.count, regions.roomCount) << "the corridor and the rooms' corners";
  // All that lies inside is in one region or other.
  for (const std::uint32_t region : regions.regionOf)
    EXPECT_TRUE(region == Regions::kNone || region < regions.count);
}

TEST(FindRooms, theRadiusIsGivenInMetresOrAsAlphaInCells) {
  FindRoomsOptions options;
  options.minWidth = 1.6;
  EXPECT_DOUBLE_EQ(roomRadius(options, 0.05), 0.8);
  options.alphaPx2 = 400;
  EXPECT_DOUBLE_EQ(roomRadius(options, 0.05), 1) << "alpha is the squared radius, and wins";
}

}  // namespace
}  // namespace roomgraph::test
