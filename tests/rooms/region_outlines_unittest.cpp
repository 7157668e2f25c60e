#include "roomgraph/rooms/region_outlines.h"

#include <gtest/gtest.h>

#include <set>

#include "MapText.h"
#include "roomgraph/pipeline/extract.h"

namespace roomgraph::test {
namespace {

/** Two rooms with a door of 1 m between them. */
Stages twoRooms() {
  std::vector<std::string> rows(22, "#" + std::string(20, '.') + "#" + std::string(20, '.') + "#");
  rows.front() = rows.back() = std::string(43, '#');
  for (std::size_t y = 8; y < 13; ++y) rows[y][21] = '.';
  const MapText map = drawn(rows, 0.2);
  return extract(greyMap(map), {});
}

constexpr double kRoomArea = 21 * 0.2 * 21 * 0.2;  // between the centres of the wall's cells

TEST(RegionOutlines, haveAShapeForEachRegion) {
  const RegionOutlines outlines = twoRooms().outlines;
  ASSERT_EQ(outlines.roomCount, 2u);
  ASSERT_EQ(outlines.rooms().size(), 2u);
  for (const Room& room : outlines.rooms()) {
    EXPECT_LT(area(room.polygon), kRoomArea);
    EXPECT_GT(area(room.polygon), 0.99 * kRoomArea) << "without triangles in the door's wall";
  }
}

TEST(RegionOutlines, corridorsAreWorthAWayFromTheMiddleOfTheRoomsUp) {
  const auto square = [](double side) {
    Room room;
    room.polygon.outer = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    return room;
  };
  RegionOutlines outlines;
  outlines.regions = {square(4), square(3), square(2), square(3), square(2.9), square(5)};
  outlines.roomCount = 3, outlines.seenCount = 5;
  const Rooms worth = outlines.worthAWay();
  ASSERT_EQ(worth.size(), 4u);
  EXPECT_EQ(area(worth.back().polygon), 9);
  outlines.roomCount = 0;
  EXPECT_TRUE(outlines.worthAWay().empty()) << "without rooms, the largest part alone is kept";
}

TEST(RegionOutlines, theBorderOfTwoRoomsIsTheirDoor) {
  const RegionOutlines outlines = twoRooms().outlines;
  std::vector<RegionBorder> doors;
  for (const RegionBorder& border : outlines.borders)
    if (border.clearance > 0.1 + 1e-9) doors.push_back(border);  // not between two wall cells
  ASSERT_EQ(doors.size(), 1u);
  EXPECT_NEAR(distance(doors[0].from, doors[0].to), 1.2, 1e-9);
  EXPECT_NEAR(doors[0].clearance, 0.6, 1e-9);
  EXPECT_EQ((std::set{doors[0].left, doors[0].right}), (std::set{0u, 1u}));
}

TEST(RegionOutlines, aBorderHasDifferentSides) {
  for (const RegionBorder& border : twoRooms().outlines.borders) {
    EXPECT_NE(border.left, border.right);
    EXPECT_NE(border.from, border.to);
  }
}

TEST(RegionOutlines, bordersRunRoundTheirRegionsWithWhatLiesInWalls) {
  // Green's formula over the borders gives the area of each region.
  const RegionOutlines outlines = twoRooms().outlines;
  std::vector<double> areas(outlines.regions.size());
  for (const RegionBorder& border : outlines.borders) {
    const double part = cross(border.from, border.to) / 2;
    if (border.left != Regions::kNone) areas[border.left] += part;
    if (border.right != Regions::kNone) areas[border.right] -= part;
  }
  for (const double area : areas) EXPECT_NEAR(area, kRoomArea, 1e-9);
}

}  // namespace
}  // namespace roomgraph::test
