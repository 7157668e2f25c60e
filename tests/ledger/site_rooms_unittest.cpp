#include "roomgraph/ledger/site_rooms.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_house.h"
#include "no_consensus.h"
#include "roomgraph/report/comparison_csv.h"
#include "roomgraph/report/comparison_json.h"

namespace roomgraph {
namespace {

using test::House;
using test::house;
using test::runOf;

/** A run, how it lies in the site, and its trust. */
struct Drawn {
  House house;
  Transform2D pose;  ///< run <- site
  double trust = 1;
};

/** The ledger of these runs, named a, b, c, ... */
std::vector<SiteRoom> ledger(const std::vector<Drawn>& all, bool isBackwards = false) {
  std::vector<roomgraph::Run> runs;
  for (std::size_t i = 0; i < all.size(); ++i)
    runs.push_back(runOf(all[i].house, std::string(1, char('a' + i)), all[i].pose));
  Site site;
  Trust trust;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t k = isBackwards ? all.size() - 1 - i : i;
    site.runs.push_back(&runs[k]);
    site.poses.push_back(all[k].pose.inverse());
    trust.push_back(all[k].trust);
  }
  std::vector<SiteRoom> rooms = siteRooms(site, test::noConsensus(site), trust);
  for (SiteRoom& room : rooms)
    if (isBackwards) std::reverse(room.runs.begin(), room.runs.end());
  return rooms;
}

/** The room that holds a place of the house. */
const SiteRoom& roomAt(const std::vector<SiteRoom>& rooms, Point p) {
  static const SiteRoom kNone;
  for (const SiteRoom& room : rooms)
    if (sideOf(room.polygon, p) == Side::inside) return room;
  ADD_FAILURE() << "no room at " << p.x << ", " << p.y;
  return kNone;
}

std::string text(const std::vector<SiteRoom>& rooms) {
  Comparison comparison;
  comparison.rooms = rooms;
  return comparisonJson(comparison);
}

const Transform2D kOther{3, -7, 1.1}, kThird{-2, 5, -2.3};
const Point kCorridor{10, 5}, kLeft{1.5, 2}, kNext{5, 2}, kRight{18, 2}, kTop{13, 9};

TEST(SiteRooms, equalRunsHaveAllRoomsInTheirPlace) {
  const auto rooms = ledger({{house(), {}}, {house(), {}}});
  ASSERT_EQ(rooms.size(), 11u);
  EXPECT_EQ(rooms.front().id, "R1");
  EXPECT_EQ(rooms[9].id, "R10");
  EXPECT_EQ(rooms.back().id, "C1");
  EXPECT_TRUE(rooms.back().isCorridor);
  EXPECT_EQ(rooms.back().doors.size(), 10u);
  for (const SiteRoom& room : rooms) {
    EXPECT_EQ(room.name, room.id);
    ASSERT_EQ(room.runs.size(), 2u);
    for (const RoomInRun& in : room.runs) {
      EXPECT_EQ(in.sighting, RoomSighting::seen);
      EXPECT_EQ(in.pieces, 1);
      EXPECT_FALSE(in.isMerged);
      EXPECT_EQ(in.shift, 0);
      EXPECT_EQ(in.areaChange, 0);
      EXPECT_EQ(in.boundaryAgreement, 1);
      EXPECT_EQ(in.lengthError.has_value(), room.isCorridor);
      EXPECT_EQ(in.doorsGained + in.doorsLost, 0);
    }
  }
}

TEST(SiteRooms, framesOfRunsDoNotMatter) {
  for (const SiteRoom& room : ledger({{house(), {}}, {house(), kOther}, {house(), kThird}}))
    for (const RoomInRun& in : room.runs) {
      EXPECT_LT(in.shift.value(), 0.01) << room.id;
      EXPECT_GT(in.boundaryAgreement.value(), 0.98) << room.id;
      EXPECT_NEAR(in.areaChange.value(), 0, 1e-6) << room.id;
    }
}

TEST(SiteRooms, theOrderOfTheRunsChangesNothing) {
  House bent = house();
  bent.bendAt = 12, bent.bend = 0.1;
  const std::vector<Drawn> runs{{house(), {}, 1}, {bent, kOther, 0.2}, {house(), kThird, 0.9}};
  EXPECT_EQ(text(ledger(runs)), text(ledger(runs, true)));
}

TEST(SiteRooms, aShiftedPartIsFoundAgainAndItsShiftTold) {
  House stretched = house();
  stretched.bendAt = 12, stretched.shift = {0.8, 0};
  const auto rooms = ledger({{house(), {}}, {house(), kOther}, {stretched, kThird, 0.3}});
  ASSERT_EQ(rooms.size(), 11u);
  EXPECT_LT(roomAt(rooms, kLeft).runs[2].shift.value(), 0.03);
  EXPECT_NEAR(roomAt(rooms, kRight).runs[2].shift.value(), 0.8, 0.05);
  EXPECT_LT(roomAt(rooms, kRight).runs[0].shift.value(), 0.03);
  EXPECT_NEAR(roomAt(rooms, kCorridor).runs[2].lengthError.value(), 0.8, 0.1);
  EXPECT_GT(roomAt(rooms, kRight).runs[2].boundaryAgreement.value(), 0.95) << "shift taken off";
}

TEST(SiteRooms, whatLiesBehindABendIsFoundThroughItsNeighbours) {
  House bent = house();
  bent.bendAt = 7.5, bent.bend = 0.25;  // the last rooms are 2.7 m off
  const auto rooms = ledger({{house(), {}}, {house(), kOther}, {bent, kThird, 0.1}});
  ASSERT_EQ(rooms.size(), 11u);
  const Point middle{18, 1.9};
  const SiteRoom& last = roomAt(rooms, middle);
  ASSERT_EQ(last.runs[2].sighting, RoomSighting::seen);
  EXPECT_NEAR(last.runs[2].shift.value(), distance(bent.drawn(middle), middle), 0.1);
  for (const SiteRoom& room : rooms) EXPECT_EQ(room.runs[2].pieces, 1) << room.id;
}

/** Gives a run of the house two scans, one of which has drawn what lies on this side of `bendAt`,
 *  and one the rest; and adds them to a consensus that has them where the house has them. */
void addHalves(roomgraph::Run& run, const House& house, const Transform2D& pose,
               Consensus& consensus) {
  for (const double x : {5.0, 15.0}) {
    ScanWalls scan;
    scan.pose = pose * Transform2D{house.drawn({x, 5}).x, house.drawn({x, 5}).y, 0};
    const GridFrame& frame = run.map.frame;
    for (std::size_t i = 0; i < run.map.states.size(); ++i) {
      const Point place = frame.center({int(i) % frame.width, int(i) / frame.width});
      if (run.map.states[i] == State::occupied &&
          (pose.inverse()(place).x > house.bendAt) == (x > house.bendAt))
        scan.walls.push_back({place, {}});
    }
    run.scans.push_back(scan);
    consensus.poses.add({x, 5, 0});
  }
  consensus.siteRuns.add(consensus.graphRuns.size());
  consensus.errors.add({});
  consensus.graphRuns.push_back(addRunNodes(run, consensus.graph));
}

TEST(SiteRooms, whatLiesBehindATearIsWhereTheConsensusHasIt) {
  House sound = house();
  sound.rooms[3].high.x = 10.9;  // no room reaches beyond the tear
  House torn = sound;
  torn.bendAt = 11, torn.shift = {0, -13};  // farther than any room is looked for
  const std::vector<Transform2D> poses{{}, kOther, kThird};
  std::vector<roomgraph::Run> runs{runOf(sound, "a", poses[0]), runOf(sound, "b", poses[1]),
                                   runOf(torn, "c", poses[2])};
  Site site;
  Consensus consensus;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    addHalves(runs[i], i == 2 ? torn : sound, poses[i], consensus);
    site.runs.push_back(&runs[i]), site.poses.push_back(poses[i].inverse());
  }
  const auto roomCount = [](const std::vector<SiteRoom>& rooms) {
    return std::count_if(rooms.begin(), rooms.end(),
                         [](const SiteRoom& room) { return !room.isCorridor; });
  };
  const auto rooms = siteRooms(site, consensus, {1, 1, 0.1});
  EXPECT_EQ(roomCount(rooms), 10);
  EXPECT_LT(roomAt(rooms, kLeft).runs[2].shift.value(), 0.03);
  EXPECT_EQ(roomAt(rooms, kRight).runs[2].sighting, RoomSighting::seen);
  EXPECT_NEAR(roomAt(rooms, kRight).runs[2].shift.value(), 13, 0.05);
  EXPECT_GT(roomCount(siteRooms(site, test::noConsensus(site), {1, 1, 0.1})), 10);
}

TEST(SiteRooms, aWallMoreSplitsARoomAndAWallLessMergesTwo) {
  House more = house(), less = house();
  more.rooms[9].high.x = 13;  // the fourth above, 11 to 15.5
  more.rooms.push_back({{13.2, 6.2}, {15.4, 11}});
  more.doors[8] = {0, 9, {12, 6.1}};
  more.doors.push_back({0, 11, {14.5, 6.1}});
  less.rooms[1].high.x = 6.9;  // takes in the second
  less.rooms.erase(less.rooms.begin() + 2);
  less.doors[1].b = 1;
  for (std::size_t i = 2; i < less.doors.size(); ++i) --less.doors[i].b;
  const auto rooms = ledger({{house(), {}}, {house(), kThird}, {more, kOther}, {less, {1, 1, 3}}});
  ASSERT_EQ(rooms.size(), 11u);
  EXPECT_EQ(roomAt(rooms, kTop).runs[2].pieces, 2);
  EXPECT_NEAR(roomAt(rooms, kTop).runs[2].areaChange.value(), 0, 0.1);
  EXPECT_EQ(roomAt(rooms, kTop).runs[3].pieces, 1);
  for (const Point p : {kLeft, kNext}) {
    EXPECT_EQ(roomAt(rooms, p).runs[3].sighting, RoomSighting::seen);
    EXPECT_TRUE(roomAt(rooms, p).runs[3].isMerged);
    EXPECT_FALSE(roomAt(rooms, p).runs[3].areaChange);
    EXPECT_FALSE(roomAt(rooms, p).runs[2].isMerged);
  }
}

TEST(SiteRooms, unknownCellsTellUnvisitedFromGone) {
  House unvisited = house(), walledUp = house(), notReached = house();
  for (House* h : {&unvisited, &walledUp, &notReached}) h->doors.erase(h->doors.begin() + 4);
  unvisited.rooms.erase(unvisited.rooms.begin() + 5);
  for (auto& door : unvisited.doors) door.b -= door.b > 5;
  notReached.rooms[5].isArea = false;
  walledUp.rooms[5].isArea = false;
  std::vector<roomgraph::Run> runs{runOf(house(), "a", {}), runOf(house(), "b", {}),
                                   runOf(unvisited, "c", {}), runOf(walledUp, "d", {}),
                                   runOf(notReached, "e", {})};
  for (std::size_t i = 0; i < runs[3].map.states.size(); ++i) {  // shelves from wall to wall
    const GridFrame& f = runs[3].map.frame;
    const Point p = f.center({int(i) % f.width, int(i) / f.width});
    if (p.x > 16 && p.x < 20 && p.y > 0 && p.y < 3.8) runs[3].map.states[i] = State::occupied;
  }
  Site site;
  for (const roomgraph::Run& run : runs) site.runs.push_back(&run), site.poses.push_back({});
  const auto rooms = siteRooms(site, test::noConsensus(site), Trust(runs.size(), 1));
  const SiteRoom& room = roomAt(rooms, kRight);
  EXPECT_EQ(room.runs[0].sighting, RoomSighting::seen);
  EXPECT_EQ(room.runs[2].sighting, RoomSighting::unvisited);
  EXPECT_EQ(room.runs[3].sighting, RoomSighting::gone);
  EXPECT_EQ(room.runs[4].sighting, RoomSighting::seen);
  EXPECT_EQ(room.runs[4].pieces, 0);
  for (const SiteRoom& other : rooms)
    for (const RoomInRun& in : other.runs)
      EXPECT_TRUE(other.id == room.id || in.sighting == RoomSighting::seen) << other.id << in.run;
}

TEST(SiteRooms, aDoorThatOneRunLacksIsLostAndOneMoreIsGained) {
  House shut = house(), open = house();
  shut.doors.erase(shut.doors.begin());  // of the room at the left
  open.doors.push_back({1, 2, {3, 2}});  // from there to the next
  const auto rooms = ledger({{house(), {}}, {house(), kOther}, {shut, {}}, {open, kThird}});
  const SiteRoom& left = roomAt(rooms, kLeft);
  ASSERT_EQ(left.doors.size(), 1u);
  EXPECT_EQ(left.doors[0].to, "C1");
  EXPECT_EQ(left.runs[2].doorsLost, 1);
  EXPECT_EQ(left.runs[2].doorsGained, 0);
  EXPECT_EQ(left.runs[3].doorsGained, 1);
  EXPECT_EQ(left.runs[3].doorsLost, 0);
  EXPECT_EQ(left.runs[0].doorsGained + left.runs[0].doorsLost, 0);
  EXPECT_EQ(roomAt(rooms, kNext).runs[3].doorsGained, 1);
  EXPECT_EQ(roomAt(rooms, kCorridor).runs[2].doorsLost, 1);
}

TEST(SiteRooms, aRoomOfOneRunIsNewOnlyIfTheRunCanBeTrusted) {
  House more = house();
  more.rooms.push_back({{20.2, 0}, {24, 3.8}});
  more.doors.push_back({5, 11, {20.1, 2}});
  const auto trusted = ledger({{house(), {}}, {house(), kOther}, {more, kThird, 0.8}});
  ASSERT_EQ(trusted.size(), 12u);
  const SiteRoom& room = roomAt(trusted, {22, 2});
  EXPECT_EQ(room.runs[0].sighting, RoomSighting::unvisited);
  EXPECT_EQ(room.runs[2].sighting, RoomSighting::seen);
  EXPECT_FALSE(room.runs[2].shift) << "nothing to compare it with";
  EXPECT_EQ(ledger({{house(), {}}, {house(), kOther}, {more, kThird, 1e-4}}).size(), 11u);
}

TEST(SiteRooms, aNarrowEndOfACorridorThatLeadsNowhereIsNoPlace) {
  House beams = house();
  beams.rooms.push_back({{20.2, 4.8}, {24, 5.2}, true});
  beams.doors.push_back({0, 11, {20.1, 5}});
  EXPECT_EQ(ledger({{beams, {}}, {beams, kOther}}).size(), 11u);
  beams.rooms.push_back({{24.2, 4}, {27, 7}});
  beams.doors.push_back({11, 12, {24.1, 5}});
  EXPECT_EQ(ledger({{beams, {}}, {beams, kOther}}).size(), 13u) << "it leads to a room";
  beams = house();
  beams.rooms.push_back({{20.2, 4}, {24, 5.8}, true});
  beams.doors.push_back({0, 11, {20.1, 5}});
  EXPECT_EQ(ledger({{beams, {}}, {beams, kOther}}).size(), 12u) << "wide enough";
}

TEST(SiteRooms, againstAReferenceAloneAllIsCounted) {
  House more = house();
  more.rooms.push_back({{20.2, 0}, {24, 3.8}});
  const auto rooms = ledger({{house(), {}, 1}, {more, kOther, 0}});
  EXPECT_EQ(rooms.size(), 12u);
}

TEST(SiteRooms, aLoneRunHasItsOwnRooms) { EXPECT_EQ(ledger({{house(), kOther}}).size(), 11u); }

TEST(SiteRooms, withoutAreasThereIsNoRoom) {
  House empty = house();
  for (auto& room : empty.rooms) room.isArea = false;
  EXPECT_TRUE(ledger({{empty, {}}, {empty, {}}}).empty());
  EXPECT_TRUE(ledger({}).empty());
}

TEST(SiteRooms, theirTableHasALineForEachRoomAndRun) {
  Comparison comparison;
  comparison.rooms = ledger({{house(), {}}, {house(), kOther}});
  comparison.rooms[0].name = "Kitchen, \"old\"";
  const std::string csv = comparisonRoomsCsv(comparison);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 11);
  EXPECT_NE(csv.find("\nR1,\"Kitchen, \"\"old\"\"\",room,"), std::string::npos);
}

TEST(SiteRooms, noNameIsAFormulaInTheirTable) {
  Comparison comparison;
  comparison.rooms = ledger({{house(), {}}, {house(), kOther}});
  for (const std::string name : {"=1+1", "+1", "-1", "@a", "\t=1"}) {
    comparison.rooms[0].name = name;
    EXPECT_NE(comparisonRoomsCsv(comparison).find("\nR1,'" + name + ","), std::string::npos)
        << name;
  }
  comparison.rooms[0].name = "=HYPERLINK(\"x\")";
  EXPECT_NE(comparisonRoomsCsv(comparison).find("\nR1,\"'=HYPERLINK(\"\"x\"\")\","),
            std::string::npos);
}

}  // namespace
}  // namespace roomgraph
