#include "roomgraph/rooms/RoomIndex.h"

#include <gtest/gtest.h>

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
}

}  // namespace
}  // namespace roomgraph::test
