#include <gtest/gtest.h>

#include <algorithm>

#include "roomgraph/measures/match_elements.h"

namespace roomgraph {
namespace {

const GridFrame kFrame{40, 30, 0.5, {-5, -5}};

Ring box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

GraphRoom room(Polygon polygon) {
  GraphRoom room;
  room.shape.polygon = std::move(polygon);
  return room;
}

GraphRoom boxRoom(double x0, double y0, double x1, double y1) {
  return room({box(x0, y0, x1, y1), {}});
}

TEST(MatchRooms, measuresTheOverlapInCells) {
  const auto matched = matchRooms({boxRoom(0, 0, 4, 3)}, {boxRoom(1, 0, 5, 3)}, kFrame);
  ASSERT_EQ(matched.size(), 1u);
  EXPECT_DOUBLE_EQ(matched[0].overlap, 9.0 / 15);
}

TEST(MatchRooms, needsMoreThanHalf) {
  EXPECT_TRUE(matchRooms({boxRoom(0, 0, 4, 3)}, {boxRoom(0, 0, 2, 3)}, kFrame).empty());
  EXPECT_EQ(matchRooms({boxRoom(0, 0, 4, 3)}, {boxRoom(0, 0, 2.5, 3)}, kFrame).size(), 1u);
}

TEST(MatchRooms, findsEachRoomWhateverItsNumber) {
  const GraphRoom left = boxRoom(-4, -4, 0, 4), right = boxRoom(1, -4, 5, 4);
  const auto matched = matchRooms({left, right}, {right, left}, kFrame);
  ASSERT_EQ(matched.size(), 2u);
  EXPECT_EQ(matched[0].base, RoomId(0));
  EXPECT_EQ(matched[0].other, RoomId(1));
  EXPECT_EQ(matched[1].other, RoomId(0));
}

TEST(MatchRooms, aSplitRoomIsFoundInItsLargerHalf) {
  const auto matched =
      matchRooms({boxRoom(-4, -4, 6, 4)}, {boxRoom(-4, -4, -2, 4), boxRoom(-2, -4, 6, 4)}, kFrame);
  ASSERT_EQ(matched.size(), 1u);
  EXPECT_EQ(matched[0].other, RoomId(1));
  EXPECT_DOUBLE_EQ(matched[0].overlap, 0.8);
}

TEST(MatchRooms, holesAreNoPartOfARoom) {
  Ring hole = box(0, 0, 3, 3);
  std::reverse(hole.begin(), hole.end());
  const GraphRoom ring = room({box(-1, -1, 4, 4), {hole}});
  EXPECT_TRUE(matchRooms({ring}, {boxRoom(0, 0, 3, 3)}, kFrame).empty());
  const auto matched = matchRooms({ring}, {boxRoom(-1, -1, 4, 4)}, kFrame);
  ASSERT_EQ(matched.size(), 1u);
  EXPECT_DOUBLE_EQ(matched[0].overlap, 16.0 / 25);
}

TEST(MatchRooms, roomsBeyondTheMapAndWithoutACellAreNotFound) {
  EXPECT_TRUE(matchRooms({boxRoom(100, 0, 104, 3)}, {boxRoom(100, 0, 104, 3)}, kFrame).empty());
  EXPECT_TRUE(matchRooms({boxRoom(0, 0, .1, .1)}, {boxRoom(0, 0, .1, .1)}, kFrame).empty());
  EXPECT_TRUE(matchRooms({}, {boxRoom(0, 0, 4, 3)}, kFrame).empty());
}

}  // namespace
}  // namespace roomgraph
