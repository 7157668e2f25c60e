#include "room_measures.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** Run 0 among others, of each of whose rooms it has so many. */
RoomCounts countsOf(const std::vector<RoomCount>& others) {
  RoomCounts counts(others.size() + 1, pairsOf(others.size() + 1));
  for (std::size_t j = 0; j < others.size(); ++j) counts(0, j + 1) = others[j];
  return counts;
}

TEST(RoomMeasures, areSharesOfTheRoomsOfAllOthers) {
  const RoomCounts counts = countsOf({{4, 3, 100, 60}, {6, 6, 100, 100}});
  const MeasuredValue matched = roomsMatchedOf(counts, {1, 1, 1}, 0);
  EXPECT_NEAR(matched.value.value(), 9.0 / 10, 1e-9);
  EXPECT_EQ(matched.support, 10);
  EXPECT_NEAR(matched.low.value(), 3.0 / 4, 1e-9);
  EXPECT_NEAR(matched.high.value(), 1, 1e-9);
  EXPECT_TRUE(matched.hasEnoughOthers);
  const MeasuredValue area = roomCoverageOf(counts, {1, 1, 1}, 0);
  EXPECT_NEAR(area.value.value(), 160.0 / 200, 1e-9);
  EXPECT_EQ(area.support, 200);
}

TEST(RoomMeasures, trustWeighsTheOthers) {
  const RoomCounts counts = countsOf({{4, 0, 100, 0}, {4, 4, 100, 100}});
  EXPECT_NEAR(roomsMatchedOf(counts, {1, 1, 3}, 0).value.value(), 3.0 / 4, 1e-9);
  const MeasuredValue single = roomsMatchedOf(counts, {1, 0, 1}, 0);
  EXPECT_NEAR(single.value.value(), 1, 1e-9) << "one without trust has no say";
  EXPECT_FALSE(single.hasEnoughOthers);
}

TEST(RoomMeasures, othersWithoutRoomsSayNothing) {
  const RoomCounts counts = countsOf({{}, {}});
  EXPECT_FALSE(roomsMatchedOf(counts, {1, 1, 1}, 0).value);
  EXPECT_FALSE(roomCoverageOf(counts, {1, 1, 1}, 0).value);
}

/** A run that has seen a square of 10 m free, with one room as large as told, from its corner. */
roomgraph::Run withRoom(double side) {
  roomgraph::Run run;
  run.map.frame = {100, 100, 0.1, {}};
  run.map.states.assign(run.map.frame.cellCount(), State::free);
  for (const Point corner : {Point{0, 0}, Point{10, 10}}) run.map.walls.push_back({corner, {1, 0}});
  GraphRoom room;
  room.center = {side / 2, side / 2};
  room.shape.polygon.outer = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  run.rooms.push_back(room);
  return run;
}

TEST(RoomMeasures, roomsThatLieOnEachOtherInTheSiteMatch) {
  const roomgraph::Run whole = withRoom(8), shifted = withRoom(8), other = withRoom(1);
  Site site;
  site.runs = {&whole, &shifted, &other};
  site.poses = {{}, {0.1, 0, 0}, {9, 9, 0}};
  const RoomCounts counts = roomCounts(site, pairsOf(3), oneByOne);
  EXPECT_EQ(counts(0, 1).matched, 1);
  EXPECT_EQ(counts(1, 0).matched, 1);
  EXPECT_EQ(counts(0, 2).matched, 0);
  EXPECT_EQ(counts(0, 2).visible, 1) << "its middle was seen free";
  EXPECT_NEAR(counts(0, 1).area, 64, 1e-9);
  EXPECT_NEAR(counts(0, 1).matchedArea, 64, 1e-9);
}

}  // namespace
}  // namespace roomgraph
