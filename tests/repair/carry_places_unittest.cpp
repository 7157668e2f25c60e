#include "roomgraph/repair/carry_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "repaired_site.h"
#include "roomgraph/align/wall_map.h"
#include "sample_drives.h"
#include "sampled_grid.h"

namespace roomgraph {
namespace {

/** A place beside each scan of a run. */
std::vector<Place> besideScans(const Run& run) {
  std::vector<Place> places;
  for (std::size_t k = 0; k < run.scans.size(); ++k)
    places.push_back({"place " + std::to_string(k), run.scans[k].pose * Transform2D{0.2, 0.1, 1}});
  return places;
}

TEST(CarryPlaces, placesFollowATornMap) {
  const test::SolvedDrives& site = test::tornAmongSound();
  const std::vector<Place> places = besideScans(site.runs[0]), there = besideScans(site.runs[1]);
  const std::vector<CarriedPlace> carried = carryPlaces(places, site.solved, site.real, 0, 1);
  ASSERT_EQ(carried.size(), places.size());
  std::size_t sure = 0;
  for (std::size_t k = 0; k < carried.size(); ++k) {
    if (carried[k].state != CarryState::carried) continue;
    ++sure;
    EXPECT_LT(distance(carried[k].pose->shift(), there[k].pose.shift()), 0.15) << k;
    EXPECT_TRUE(carried[k].reason.empty());
  }
  EXPECT_GE(2 * sure, carried.size());
  for (const std::size_t k : {18, 19, 21})  // beside the break at 20
    EXPECT_EQ(carried[k].state, CarryState::unsure) << k;
}

/** There and back, backwards, over the same places, each scan of a log of its own. */
std::vector<Keyframe> thereAndBack(std::uint64_t log) {
  std::vector<Keyframe> frames = test::driveForthAndBack();
  for (std::size_t k = 0; k < frames.size(); ++k) frames[k].scanId = 1000 * log + k;
  return frames;
}

TEST(CarryPlaces, nothingIsSureOfARunWhoseOwnBeamsRefuteIt) {
  const auto welded = test::broken(thereAndBack(3), 50, 0, {0.5, 1.5});
  test::SolvedDrives site({thereAndBack(1), thereAndBack(2), welded});
  const auto refutedTo = [&](std::size_t to) {
    const auto all = carryPlaces(besideScans(site.runs[0]), site.solved, site.real, 0, to);
    return std::count_if(all.begin(), all.end(), [](const CarriedPlace& place) {
      return place.reason.find("lays places over each other") != std::string::npos;
    });
  };
  // As where all of the welded run fits the others, in a building that repeats itself.
  Consensus& consensus = site.solved.consensus;
  consensus.poses = consensus.graph.ownPoses();
  for (std::size_t i = 0; i < site.runs.size(); ++i) site.real[i] = drawnPoses(site.runs[i].scans);
  for (MapError& error : consensus.errors) error.error = error.high = 0.1;
  EXPECT_GT(refutedTo(2), 0);
  EXPECT_EQ(refutedTo(1), 0);
}

TEST(CarryPlaces, whatNobodyHasBeenNearIsUnseen) {
  const test::SolvedDrives& site = test::tornAmongSound();
  const auto carried = carryPlaces({{"far", {500, 0, 0}}}, site.solved, site.real, 0, 2);
  EXPECT_EQ(carried[0].state, CarryState::unseen);
  EXPECT_FALSE(carried[0].pose);
  EXPECT_FALSE(carried[0].reason.empty());
}

/** Places of run 0 that its map does not know, up to 5 m beside its scans. */
std::vector<Transform2D> unknownPlaces(const Run& run) {
  std::vector<Transform2D> poses;
  for (const ScanWalls& scan : run.scans)
    for (const double beside : {-5.0, -4.0, -3.0, 3.0, 4.0, 5.0}) {
      const Transform2D pose = scan.pose * Transform2D{0, beside, 0};
      const Cell cell = run.map.frame.cellAt(pose.shift());
      if (!run.map.frame.contains(cell) ||
          run.map.states[run.map.frame.index(cell)] == State::unknown)
        poses.push_back(pose);
    }
  return poses;
}

TEST(CarryPlaces, cornersThatNeitherMapKnowsGoAlongWithWhatLiesBeside) {
  const test::SolvedDrives site({test::drive(1), test::drive(2), test::drive(3)});
  std::size_t carried = 0;
  for (const Transform2D& pose : unknownPlaces(site.runs[0])) {
    const Place corner{"corner", pose, true};
    const CarriedPlace there = carryPlaces({corner}, site.solved, site.real, 0, 1)[0];
    if (there.state == CarryState::unseen) continue;
    carried += there.state == CarryState::carried;
    EXPECT_LT(distance(there.pose->shift(), pose.shift()), 0.1);
  }
  EXPECT_GE(carried, 1u);
}

TEST(CarryPlaces, ofAGoalWhereTheOldMapHasNoFreeSpaceNothingIsSure) {
  const test::SolvedDrives site({test::drive(1), test::drive(2), test::drive(3)});
  std::size_t flagged = 0;
  for (const Transform2D& pose : unknownPlaces(site.runs[0])) {
    const CarriedPlace goal = carryPlaces({{"goal", pose}}, site.solved, site.real, 0, 1)[0];
    flagged += goal.reason == "the old map shows no free space there";
  }
  EXPECT_GE(flagged, 1u);
}

TEST(CarryPlaces, ofTwoMapsThatAreOnlySaidToBeOfOneSiteNothingIsSure) {
  test::SolvedDrives site({test::drive(1), test::drive(2)});
  const Place place{"goal", site.runs[0].scans[10].pose};
  EXPECT_EQ(carryPlaces({place}, site.solved, site.real, 0, 1)[0].state, CarryState::carried);
  site.solved.pairs(0, 1).alignment.isOnlySaid = true;
  const CarriedPlace carried = carryPlaces({place}, site.solved, site.real, 0, 1)[0];
  EXPECT_EQ(carried.state, CarryState::unsure);
  EXPECT_TRUE(carried.pose);
}

TEST(CarryPlaces, whereNearlyAllPlacesAreAmbiguousNoneIsCarried) {
  test::SolvedDrives site({test::drive(1), test::drive(2)});
  Alignment& alignment = site.solved.pairs(0, 1).alignment;
  alignment.confidence = 0.5, alignment.poses = {{100, 0, 0}}, alignment.runnerUp.reset();
  std::vector<Place> places{{"goal", site.runs[0].scans[10].pose}};
  EXPECT_EQ(carryPlaces(places, site.solved, site.real, 0, 1)[0].state, CarryState::carried);
  for (const Transform2D& unknown : unknownPlaces(site.runs[0]))
    if (places.size() < 8) places.push_back({"corner", unknown, true});
  const std::vector<CarriedPlace> carried = carryPlaces(places, site.solved, site.real, 0, 1);
  EXPECT_EQ(carried[0].state, CarryState::unsure);
  EXPECT_EQ(carried[0].reason, carried.back().reason);
  EXPECT_TRUE(carried[0].pose);
}

TEST(CarryPlaces, aPlaceInANewWallIsGone) {
  test::SolvedDrives site({test::drive(1), test::drive(2), test::drive(3)});
  const Place place{"goal", site.runs[0].scans[10].pose};
  EXPECT_EQ(carryPlaces({place}, site.solved, site.real, 0, 1)[0].state, CarryState::carried);
  WallMap& map = site.runs[1].map;
  for (std::size_t cell = 0; cell < map.states.size(); ++cell)
    if (distance(map.placeOf(cell), place.pose.shift()) < 0.6) map.states[cell] = State::occupied;
  EXPECT_EQ(carryPlaces({place}, site.solved, site.real, 0, 1)[0].state, CarryState::gone);
  const Place corner{"zone", place.pose, true};  // outlines may run along walls
  EXPECT_NE(carryPlaces({corner}, site.solved, site.real, 0, 1)[0].state, CarryState::gone);
}

TEST(CarryPlaces, aPlaceJustInsideOfAWallIsNotGone) {
  test::SolvedDrives site({test::drive(1), test::drive(2), test::drive(3)});
  const Place place{"goal", site.runs[0].scans[10].pose};
  const CarriedPlace before = carryPlaces({place}, site.solved, site.real, 0, 1)[0];
  WallMap& map = site.runs[1].map;
  map.states[map.frame.index(map.frame.cellAt(before.pose->shift()))] = State::occupied;
  ASSERT_LT(3 * before.error, map.frame.resolution) << "cells are coarse";
  EXPECT_EQ(carryPlaces({place}, site.solved, site.real, 0, 1)[0].reason,
            "it lies in a wall, with free space beside it");
}

/** Two rooms of 6 m beside each other, with a wall between, from (0, 0) on. */
WallMap twoRooms() {
  return wallMap(test::sampledGrid({261, 141, 0.05, {-0.5, -0.5}}, [](Point p) {
    const bool isInside = p.y > 0 && p.y < 6 && p.x > 0 && p.x < 12;
    const bool isWall = p.x > 5.9 && p.x < 6.1;
    const bool isNear = p.y > -0.2 && p.y < 6.2 && p.x > -0.2 && p.x < 12.2;
    return isInside && !isWall ? State::free : isNear ? State::occupied : State::unknown;
  }));
}

TEST(ViewFrom, wallsOfTheRoomAreSeenAndNoneBehindThem) {
  const WallMap map = twoRooms();
  const LocalScan view = viewFrom(map, {3, 3, 0}, 12);
  ASSERT_TRUE(view.isTelling());
  for (const WallPoint& wall : view.walls) {
    EXPECT_LT(std::max(std::abs(wall.place.x), std::abs(wall.place.y)), 3.2);
    EXPECT_LT(dot(wall.normal, wall.place), 0) << "it faces the place";
  }
  EXPECT_LT(viewFrom(map, {3, 3, 0}, 3.5).walls.size(), view.walls.size());
}

TEST(ViewFrom, isInTheFrameOfThePlace) {
  const WallMap map = twoRooms();
  const LocalScan straight = viewFrom(map, {1, 2, 0}, 12), turned = viewFrom(map, {1, 2, 2}, 12);
  ASSERT_EQ(straight.walls.size(), turned.walls.size());
  const Motion2D back(Transform2D{0, 0, -2});
  for (std::size_t i = 0; i < turned.walls.size(); ++i)
    EXPECT_LT(distance(back(straight.walls[i].place), turned.walls[i].place), 1e-9);
}

TEST(ViewFrom, nothingIsSeenOutsideOfTheMap) {
  EXPECT_TRUE(viewFrom(twoRooms(), {500, 0, 0}, 12).walls.empty());
  EXPECT_TRUE(viewFrom(WallMap{}, {}, 12).walls.empty());
}

}  // namespace
}  // namespace roomgraph
