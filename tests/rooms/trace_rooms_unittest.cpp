#include "roomgraph/rooms/trace_rooms.h"

#include <gtest/gtest.h>

#include "plan.h"

namespace roomgraph::test {
namespace {

/** A room of 18 x 18 m, to draw things into. */
std::vector<std::string> emptyRoom() {
  std::vector<std::string> rows(20, std::string(20, '.'));
  rows.front() = rows.back() = std::string(20, '#');
  for (std::string& row : rows) row.front() = row.back() = '#';
  return rows;
}

Rooms roomsOf(const MapText& map, double radius) {
  const DividedByDisc divided(map, radius);
  Rooms rooms = traceRegions(divided.voronoi, divided.regions);
  rooms.resize(divided.regions.roomCount);
  return rooms;
}

TEST(TraceRooms, theOuterRingRunsCounterClockwiseAndTheHolesClockwise) {
  std::vector<std::string> rows = emptyRoom();
  rows[9][9] = rows[9][10] = rows[10][9] = rows[10][10] = '#';
  const Rooms rooms = roomsOf(drawn(rows, 1), 2);
  ASSERT_EQ(rooms.size(), 1u);
  // The disc does not fill the corners: each loses a triangle with legs of 2.
  EXPECT_DOUBLE_EQ(signedArea(rooms[0].polygon.outer), 19 * 19 - 4 * 2);
  ASSERT_EQ(rooms[0].polygon.holes.size(), 1u);
  EXPECT_DOUBLE_EQ(signedArea(rooms[0].polygon.holes[0]), -1);
}

TEST(TraceRooms, aThinWallThatReachesInEnclosesNothing) {
  std::vector<std::string> rows = emptyRoom();
  for (std::size_t y = 10; y < 19; ++y) rows[y][9] = '#';
  const Rooms rooms = roomsOf(drawn(rows, 1), 2);
  ASSERT_EQ(rooms.size(), 1u);
  EXPECT_TRUE(rooms[0].polygon.holes.empty());
  // Four corners of the room and two at the foot of the wall.
  EXPECT_DOUBLE_EQ(area(rooms[0].polygon), 19 * 19 - 6 * 2);
  for (const Point p : rooms[0].polygon.outer) {
    EXPECT_TRUE(p.x != 9.5 || p.y < 3 || p.y > 19) << p.y;
  }
}

TEST(TraceRooms, aPostThatTouchesTheWallDiagonallyMakesAHole) {
  std::vector<std::string> rows = emptyRoom();
  for (std::size_t y : {1, 2, 3})
    for (std::size_t x : {8, 9, 10}) rows[y + 1][x] = '#';
  rows[1][8] = '#';
  const Rooms rooms = roomsOf(drawn(rows, 1), 2);
  ASSERT_EQ(rooms.size(), 1u);
  double sum = signedArea(rooms[0].polygon.outer);
  for (const Ring& hole : rooms[0].polygon.holes) {
    EXPECT_LT(signedArea(hole), 0);
    sum += signedArea(hole);
  }
  EXPECT_DOUBLE_EQ(area(rooms[0].polygon), sum);
  EXPECT_LT(sum, 19 * 19 - 3);
}

TEST(TraceRooms, theWidestPlaceIsTheCentreOfTheLargestDisc) {
  const Rooms rooms = roomsOf(drawn(emptyRoom(), 1), 2);
  ASSERT_EQ(rooms.size(), 1u);
  EXPECT_NEAR(distance(rooms[0].widestPlace, {10, 10}), 0, 1e-9);
  EXPECT_NEAR(rooms[0].inscribedRadius, 9.5, 0.02) << "between the centres of cells";
}

TEST(TraceRooms, regionsAreRoomsFirstAndCorridorsAfterThem) {
  const MapText map = drawn({"#############", "#....########", "#....########", "#...........#",
                             "#....########", "#....########", "#############"},
                            1);
  const DividedByDisc divided(map, 1.6);
  const Regions& regions = divided.regions;
  const Rooms all = traceRegions(divided.voronoi, regions);
  ASSERT_GT(regions.roomCount, 0u);
  ASSERT_GT(regions.count, regions.roomCount);
  ASSERT_EQ(all.size(), regions.count);
  for (std::size_t r = 0; r < all.size(); ++r) {
    EXPECT_EQ(all[r].region, r);
    EXPECT_GT(all[r].inscribedRadius, r < regions.roomCount ? 1.6 : 0);
  }
}

}  // namespace
}  // namespace roomgraph::test
