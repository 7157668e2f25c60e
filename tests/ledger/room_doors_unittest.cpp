#include "room_doors.h"

#include <gtest/gtest.h>

#include "drawn_areas.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph::test {
namespace {

/** The doors of the upper room, by what each run says of them. */
RoomDoors doorsOfUpperRoom(const std::vector<RunAreas>& runs, bool isLastClean = true) {
  const SiteAreas site{frameOf(threeRooms()), runs};
  const ConsensusRooms consensus = consensusRooms(site, oneByOne);
  std::vector<RoomsInRun> inRuns;
  for (const auto& matches : consensus.matches) {
    inRuns.push_back({std::vector<bool>(matches.size(), true), {}});
    for (const AreaMatch& match : matches) inRuns.back().moves.push_back(match.move);
  }
  std::size_t upper = 0;
  while (sideOf(consensus.rooms.shapes[upper].polygon, {8, 6.5}) != Side::inside) ++upper;
  inRuns.back().isClean[upper] = isLastClean;
  return roomDoors(site, consensus, upper, inRuns);
}

RunAreas withDoors(const std::vector<DrawnDoor>& doors, double weight = 1) {
  return drawnAreas(threeRooms(), doors, weight);
}

const DrawnDoor kDown{'B', 'd', {8, 5.25}}, kAside{'A', 'B', {4.75, 6.5}, true};
using Counts = std::vector<int>;

TEST(RoomDoors, areThoseThatTheRunsAgreeOn) {
  const RunAreas run = withDoors({kDown, kAside});
  const RoomDoors doors = doorsOfUpperRoom({run, run, run});
  ASSERT_EQ(doors.doors.size(), 2u);
  for (const RoomDoors::Door& door : doors.doors) {
    EXPECT_TRUE(door.to);
    EXPECT_DOUBLE_EQ(door.width(), 1);
    EXPECT_TRUE(door.place() == kDown.place || door.place() == kAside.place);
  }
  EXPECT_EQ(doors.gained, (Counts{0, 0, 0}));
  EXPECT_EQ(doors.lost, (Counts{0, 0, 0}));
}

TEST(RoomDoors, whatOneOfThreeLacksItHasLost) {
  const RunAreas both = withDoors({kDown, kAside});
  const RoomDoors doors = doorsOfUpperRoom({both, withDoors({kDown}), both});
  EXPECT_EQ(doors.doors.size(), 2u);
  EXPECT_EQ(doors.lost, (Counts{0, 1, 0}));
  EXPECT_EQ(doors.gained, (Counts{0, 0, 0}));
  using Runs = std::vector<std::size_t>;
  for (const RoomDoors::Door& door : doors.doors) {
    const bool isAside = door.place() == kAside.place;
    EXPECT_EQ(door.seenIn, isAside ? (Runs{0, 2}) : (Runs{0, 1, 2}));
    EXPECT_EQ(door.lostIn, isAside ? (Runs{1}) : (Runs{}));
  }
}

TEST(RoomDoors, whatOneOfThreeHasAloneItHasGained) {
  const RunAreas one = withDoors({kDown});
  const RoomDoors doors = doorsOfUpperRoom({one, one, withDoors({kDown, kAside})});
  EXPECT_EQ(doors.doors.size(), 1u);
  EXPECT_EQ(doors.gained, (Counts{0, 0, 1}));
}

/** The upper room's door drawn as a gap in the wall, so that nothing bars it. */
std::vector<std::string> withGap() {
  std::vector<std::string> rows = threeRooms();
  rows[5].replace(15, 2, "..");
  return rows;
}

TEST(RoomDoors, whatNoWallBarsIsNotLost) {
  // The same gap is a door in one run's graph and none in that of another.
  const RunAreas door = drawnAreas(withGap(), {kDown}), none = drawnAreas(withGap(), {});
  EXPECT_EQ(doorsOfUpperRoom({door, none, door}).lost, (Counts{0, 0, 0}));
  EXPECT_EQ(doorsOfUpperRoom({door, none, none}).gained, (Counts{0, 0, 0}));
  const RunAreas wall = withDoors({});
  EXPECT_EQ(doorsOfUpperRoom({door, wall, door}).lost, (Counts{0, 1, 0}));
  EXPECT_EQ(doorsOfUpperRoom({door, wall, wall}).gained, (Counts{1, 0, 0}));
}

TEST(RoomDoors, aDoorThatIsShutIsLostThoughNobodyHasSeenBehindIt) {
  std::vector<std::string> rows = withGap();
  for (std::size_t y = 1; y < 5; ++y) rows[y].replace(11, 10, std::string(10, ' '));
  rows[5] = threeRooms()[5];
  const RunAreas open = drawnAreas(withGap(), {kDown});
  const SiteAreas site{frameOf(rows), {open, drawnAreas(rows, {}), open}};
  const ConsensusRooms consensus = consensusRooms(site, oneByOne);
  std::size_t corridor = 0;
  while (!consensus.rooms.shapes[corridor].isCorridor) ++corridor;
  std::vector<RoomsInRun> inRuns;
  for (const auto& matches : consensus.matches)
    inRuns.push_back({std::vector<bool>(matches.size(), true), mapped(matches, &AreaMatch::move)});
  EXPECT_EQ(roomDoors(site, consensus, corridor, inRuns).lost, (Counts{0, 1, 0}));
}

TEST(RoomDoors, aGapAsFarBesideADoorAsMapsBendIsNoWall) {
  const RunAreas door = withDoors({kDown});
  const auto lostBy = [&](std::size_t moved) {  // in steps of half a metre, from the edge
    std::vector<std::string> rows = threeRooms();
    rows[5].replace(17 + moved, 2, "..");
    return doorsOfUpperRoom({door, drawnAreas(rows, {}), door}).lost[1];
  };
  EXPECT_EQ(lostBy(0), 0);
  EXPECT_EQ(lostBy(1), 1);
}

TEST(RoomDoors, weightDecidesNotTheNumberOfRuns) {
  const RunAreas both = withDoors({kDown, kAside}, 3), one = withDoors({kDown});
  EXPECT_EQ(doorsOfUpperRoom({both, one, one}).doors.size(), 2u);
}

TEST(RoomDoors, aDoorToTheSameRoomIsTheSameWithinOneAndAHalfMetres) {
  const RunAreas here = withDoors({kDown});
  const auto beside = [&](double x) {
    return doorsOfUpperRoom({here, here, withDoors({{'B', 'd', {8 + x, 5.25}}})});
  };
  EXPECT_EQ(beside(1.4).gained, (Counts{0, 0, 0}));
  EXPECT_EQ(beside(1.4).lost, (Counts{0, 0, 0}));
  EXPECT_EQ(beside(1.6).gained, (Counts{0, 0, 1}));
  EXPECT_EQ(beside(1.6).lost, (Counts{0, 0, 1}));
}

TEST(RoomDoors, aRunThatHasNotLookedThereHasLostNothing) {
  std::vector<std::string> rows = threeRooms();
  for (std::size_t y = 1; y < 6; ++y) rows[y].replace(0, 11, std::string(11, ' '));
  const RunAreas both = withDoors({kDown, kAside});
  const RoomDoors doors = doorsOfUpperRoom({both, both, drawnAreas(rows, {kDown})});
  EXPECT_EQ(doors.doors.size(), 2u);
  EXPECT_EQ(doors.lost, (Counts{0, 0, 0}));
}

TEST(RoomDoors, aRunInWhichTheRoomIsNoAreaOfItsOwnSaysNothing) {
  const RunAreas both = withDoors({kDown, kAside});
  const RoomDoors doors = doorsOfUpperRoom({both, both, withDoors({})}, false);
  EXPECT_EQ(doors.doors.size(), 2u);
  EXPECT_EQ(doors.lost, (Counts{0, 0, 0}));
}

TEST(RoomDoors, theOrderOfTheOtherRunsChangesNothing) {
  const RunAreas both = withDoors({kDown, kAside}), one = withDoors({kDown});
  const RoomDoors forth = doorsOfUpperRoom({both, one, both, one, both});
  const RoomDoors back = doorsOfUpperRoom({both, both, one, one, both});
  EXPECT_EQ(forth.doors.size(), back.doors.size());
  EXPECT_EQ(forth.lost, (Counts{0, 1, 0, 1, 0}));
  EXPECT_EQ(back.lost, (Counts{0, 0, 1, 1, 0}));
}

TEST(RoomDoors, halfOfTheWeightIsNotEnough) {
  const RunAreas both = withDoors({kDown, kAside}), one = withDoors({kDown});
  const RoomDoors doors = doorsOfUpperRoom({both, one});
  EXPECT_EQ(doors.doors.size(), 1u);
  EXPECT_EQ(doors.gained, (Counts{1, 0}));
}

TEST(RoomDoors, doorsToDifferentRoomsAreTwoWhereTheyAreApart) {
  // Where the room behind is another one, they must be nearer to be one.
  const RunAreas here = withDoors({{'B', 'd', {8, 5.25}}});
  const auto beside = [&](double x) {
    return doorsOfUpperRoom({here, here, withDoors({{'B', 'C', {8 + x, 5.25}}})});
  };
  EXPECT_EQ(beside(0.7).gained, (Counts{0, 0, 0}));
  EXPECT_EQ(beside(1.2).gained, (Counts{0, 0, 1}));
}

TEST(RoomDoors, twoDoorsOfARunAreNeverOne) {
  const RunAreas two = withDoors({{'B', 'd', {7, 5.25}}, {'B', 'd', {8, 5.25}}});
  const RoomDoors doors = doorsOfUpperRoom({two, two, two});
  EXPECT_EQ(doors.doors.size(), 2u);
  EXPECT_EQ(doors.gained, (Counts{0, 0, 0}));
  EXPECT_EQ(doors.lost, (Counts{0, 0, 0}));
}

TEST(RoomDoors, aDoorIsJoinedToTheNearest) {
  const RunAreas two = withDoors({{'B', 'd', {7, 5.25}}, {'B', 'd', {8.2, 5.25}}});
  const RoomDoors doors = doorsOfUpperRoom({two, two, withDoors({{'B', 'd', {7.9, 5.25}}})});
  EXPECT_EQ(doors.doors.size(), 2u);
  EXPECT_EQ(doors.lost, (Counts{0, 0, 1})) << "the one that is farther";
  EXPECT_EQ(doors.gained, (Counts{0, 0, 0}));
}

TEST(RoomDoors, aRoomWithoutDoorsHasNone) {
  const RunAreas none = withDoors({});
  const RoomDoors doors = doorsOfUpperRoom({none, none});
  EXPECT_TRUE(doors.doors.empty());
  EXPECT_EQ(doors.lost, (Counts{0, 0}));
}

}  // namespace
}  // namespace roomgraph::test
