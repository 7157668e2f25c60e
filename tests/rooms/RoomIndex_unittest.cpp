#include "roomgraph/rooms/RoomIndex.h"

#include <gtest/gtest.h>

#include <cmath>

#include "RandomNumbers.h"
#include "roomgraph/geometry/intersect.h"
#include "square_rooms.h"

namespace roomgraph::test {
namespace {

TEST(RoomIndex, tellsTheRoomAtAPlace) {
  const RoomIndex index({squareRoom(0, 0), squareRoom(10, 0)}, kClearance);
  EXPECT_EQ(index.roomAt({2, 2}), RoomId(0));
  EXPECT_EQ(index.roomAt({11, 3.9}), RoomId(1));
  EXPECT_FALSE(index.roomAt({7, 2}));
  EXPECT_FALSE(index.roomAt({-100, 100}));
}

TEST(RoomIndex, aRoomHoldsNeitherItsBoundaryNorItsHoles) {
  Room room = squareRoom(0, 0);
  room.polygon.holes = {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}};
  const RoomIndex index({room}, kClearance);
  EXPECT_FALSE(index.roomAt({4, 2}));
  EXPECT_FALSE(index.roomAt({0, 0}));
  EXPECT_FALSE(index.roomAt({1.5, 1.5}));
  EXPECT_FALSE(index.roomAt({1, 1.5}));
  EXPECT_EQ(index.roomAt({2.5, 1.5}), RoomId(0));
}

TEST(RoomIndex, findsTheOpeningsThatASegmentPasses) {
  const RoomIndex index({squareRoom(0, 0), squareRoom(40, 0)}, kClearance);
  const auto near = index.openingsNear({3, 2}, {5, 2});
  const RoomIndex::Opening right{{4, 0}, {4, 4}};
  EXPECT_EQ(std::count(near.begin(), near.end(), right), 1) << "once, and at all";
  EXPECT_LE(near.size(), 4u) << "none of the other room";
  EXPECT_TRUE(index.openingsNear({20, 20}, {21, 20}).empty());
}

TEST(RoomIndex, anEdgeTooShortToPassIsNoOpening) {
  EXPECT_FALSE(RoomIndex({squareRoom(0, 0)}, 2).openingsNear({3, 2}, {5, 2}).empty());
  EXPECT_TRUE(RoomIndex({squareRoom(0, 0)}, 2.1).openingsNear({3, 2}, {5, 2}).empty());
  EXPECT_TRUE(RoomIndex({}, 1).openingsNear({3, 2}, {5, 2}).empty());
  EXPECT_TRUE(RoomIndex({squareRoom(0, 0)}).openingsNear({3, 2}, {5, 2}).empty()) << "not asked";
}

/** Rooms with ragged outlines in squares of 10 m, some with a hole. */
Rooms raggedRooms(RandomNumbers& random) {
  Rooms rooms;
  for (int i = 0; i < 9; ++i) {
    const Point middle{10.0 * (i % 3), 10.0 * (i / 3)};
    Room room;
    const int corners = 5 + int(random.below(12));
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * M_PI * k / corners, far = random.between(2, 4.9);
      room.polygon.outer.push_back(middle + far * Point{std::cos(angle), std::sin(angle)});
    }
    if (i % 2 == 0)
      room.polygon.holes = {
          {middle, middle + Point{0, 1}, middle + Point{1, 1}, middle + Point{1, 0}}};
    rooms.push_back(room);
  }
  return rooms;
}

TEST(RoomIndex, tellsWhatPlainSearchTells) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 5; ++trial) {
    const Rooms rooms = raggedRooms(random);
    const RoomIndex index(rooms, kClearance);
    std::size_t found = 0;
    for (int i = 0; i < 2000; ++i) {
      const Point p{random.between(-6, 26), random.between(-6, 26)};
      RoomId expected = RoomId::none();
      for (std::size_t r = 0; r < rooms.size(); ++r)
        if (sideOf(rooms[r].polygon, p) == Side::inside) expected = RoomId(r);
      EXPECT_EQ(index.roomAt(p), expected) << p.x << ' ' << p.y;
      found += bool(expected);
    }
    EXPECT_GT(found, 300u);
  }
}

TEST(RoomIndex, missesNoOpeningThatASegmentCrosses) {
  RandomNumbers random(2);
  const Rooms rooms = raggedRooms(random);
  const RoomIndex index(rooms, kClearance);
  std::size_t crossed = 0;
  for (int i = 0; i < 500; ++i) {
    const Point p{random.between(-6, 26), random.between(-6, 26)}, q = p + random.place(3);
    const auto near = index.openingsNear(p, q);
    for (const auto& [a, b] : near) EXPECT_GE(distance(a, b), 2 * kClearance * (1 - 1e-6));
    for (const Room& room : rooms)
      for (std::size_t k = 0; k < room.polygon.outer.size(); ++k) {
        const Point a = room.polygon.outer[k],
                    b = room.polygon.outer[(k + 1) % room.polygon.outer.size()];
        if (distance(a, b) < 2 * kClearance || intersect(p, q, a, b).empty()) continue;
        ++crossed;
        EXPECT_EQ(std::count(near.begin(), near.end(), RoomIndex::Opening(a, b)), 1);
      }
  }
  EXPECT_GT(crossed, 50u);
}

}  // namespace
}  // namespace roomgraph::test
