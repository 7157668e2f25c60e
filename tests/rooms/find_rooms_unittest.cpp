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

/** The widest place of the first room of a plan. */
double xOfFirstRoom(const MapText& map, double radius) {
  const DividedByDisc plan(map, radius);
  double x = 0, most = 0;
  for (std::size_t v = 0; v < plan.regions.regionOf.size(); ++v) {
    const VoronoiVertex& vertex = plan.voronoi.vertices[v];
    if (plan.regions.regionOf[v] == 0 && vertex.clearance > most)
      most = vertex.clearance, x = vertex.place.x;
  }
  return x;
}

TEST(FindRooms, theLargestRoomIsTheFirst) {
  const MapText largeLeft =
      drawn({"#####################", "#.........###.......#", "#.........###.......#",
             "#...................#", "#.........###.......#", "#.........###.......#",
             "#####################"},
            1);
  const MapText largeRight =
      drawn({"#####################", "#.......###.........#", "#.......###.........#",
             "#...................#", "#.......###.........#", "#.......###.........#",
             "#####################"},
            1);
  EXPECT_LT(xOfFirstRoom(largeLeft, 2), 10);
  EXPECT_GT(xOfFirstRoom(largeRight, 2), 11);
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
