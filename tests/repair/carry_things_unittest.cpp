#include "roomgraph/repair/carry_things.h"

#include <gtest/gtest.h>

#include "repaired_site.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

CarriedPlace placeOf(CarryState state, double error, const std::string& reason = "") {
  CarriedPlace place;
  place.pose = Transform2D{1, 0, 0}, place.state = state, place.error = error,
  place.reason = reason;
  return place;
}

/** Places every half metre along a line. */
std::vector<Transform2D> line(int count) {
  std::vector<Transform2D> places;
  for (int i = 0; i < count; ++i) places.push_back({0.5 * i, 0, 0});
  return places;
}

MarkedFile fileOf(std::vector<Thing> things, std::size_t places) {
  MarkedFile file;
  file.things = std::move(things);
  file.places.resize(places);
  return file;
}

TEST(CarryThings, aThingIsAsSureAsItsLeastSurePlace) {
  const auto things = carriedThings(
      fileOf({{"all", {0, 1, 2}}, {"sure", {0}}, {"with corners", {0}, {1, 2}}, {"nothing", {}}},
             3),
      {placeOf(CarryState::carried, 0.1), placeOf(CarryState::gone, 0.2, "a wall"),
       placeOf(CarryState::unsure, 0.3, "a bend")},
      {});
  ASSERT_EQ(things.size(), 4u);
  EXPECT_EQ(things[0].state, CarryState::gone);
  EXPECT_EQ(things[0].reason, "a wall");
  EXPECT_EQ(things[0].error, 0.3);
  EXPECT_EQ(things[1].state, CarryState::carried);
  EXPECT_EQ(things[1].error, 0.1);
  EXPECT_EQ(things[2].state, CarryState::carried);
  EXPECT_EQ(things[2].poses.size(), 3u);
  EXPECT_EQ(things[3].state, CarryState::unsure);
  EXPECT_EQ(things[3].reason, "it has no place in its file");
  EXPECT_FALSE(things[3].error);
}

TEST(CarryThings, whatIsNotKnownGoesAlongWithWhatIs) {
  MarkedFile file = fileOf({{"both", {0, 1}}}, 2);
  file.places[1].pose = {3, 4, 0};
  const auto known =
      carriedThings(file, {placeOf(CarryState::carried, 0.1), CarriedPlace()}, {9, 9, 0});
  EXPECT_EQ(known[0].poses[1].shift(), (Point{4, 4}));
  EXPECT_EQ(known[0].state, CarryState::unseen);
  EXPECT_FALSE(known[0].error);
  const auto unknown = carriedThings(file, {CarriedPlace(), CarriedPlace()}, {9, 9, 0});
  EXPECT_EQ(unknown[0].poses[1].shift(), (Point{12, 13}));
}

TEST(CarryThings, aLaneFollowsADriftingMap) {
  const test::SolvedDrives& site = test::tornAmongSound();
  MarkedFile file = fileOf({{"lane", {0, 1, 2}}}, 3);
  for (std::size_t i = 0; i < 3; ++i) file.places[i].pose = site.runs[0].scans[3 * i].pose;
  const auto things = carryThings(file, site.solved, site.real, 0, 2, oneByOne);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(distance(things[0].poses[i].shift(), site.runs[2].scans[3 * i].pose.shift()), 0.15);
}

std::vector<Transform2D> moved(std::vector<Transform2D> places, double along) {
  for (Transform2D& place : places) place.y += along;
  return places;
}

TEST(CarryThings, edgesEndAtTheirNodesAlsoWhereTheseJump) {
  MarkedFile file = fileOf({{"node", {0}}, {"edge", numbersFrom(0, 20)}}, 20);
  std::vector<CarriedPlace> carried(20, placeOf(CarryState::carried, 0.1));
  for (std::size_t i = 0; i < 20; ++i) {
    file.places[i].pose = line(20)[i];
    carried[i].pose = Transform2D{0.5 * double(i), i == 0 || i == 9 ? 2.0 : 0.0, 0};
  }
  const auto things = carriedThings(file, carried, {});
  EXPECT_EQ(things[1].poses[0].shift(), things[0].poses[0].shift());
  EXPECT_EQ(things[1].poses[0].y, 2);
  EXPECT_NEAR(things[1].poses[9].y, 0, 1e-9) << "what is no node keeps the shape";
  EXPECT_EQ(things[0].state, CarryState::carried);
  EXPECT_EQ(things[1].state, CarryState::unsure) << "its parts lie apart";
}

TEST(KeepShape, onesThatJumpFollowTheirNeighbours) {
  const auto were = line(20), sound = moved(were, 3);
  auto poses = sound;
  poses[7].y += 2, poses[8].y += 2, poses[15].y -= 1;
  const auto hasMoved = keepShape(were, poses);
  for (std::size_t i = 0; i < were.size(); ++i) {
    EXPECT_NEAR(distance(poses[i].shift(), sound[i].shift()), 0, 1e-9) << i;
    EXPECT_EQ(hasMoved[i], i == 7 || i == 8 || i == 15) << i;
  }
}

TEST(KeepShape, largeAreasTakeNoLongerThanTheirSize) {
  std::vector<Transform2D> were{{1e4, 0, 0}};  // one lies far off
  for (int i = 0; i < 90000; ++i) were.push_back({0.5 * (i % 300), 0.5 * (i / 300), 0});
  auto poses = moved(were, 3);
  for (std::size_t i = 1; i < were.size(); i += 97) poses[i].x -= 2;
  const auto hasMoved = keepShape(were, poses);
  const auto sound = moved(were, 3);
  for (std::size_t i = 0; i < were.size(); ++i) {
    ASSERT_NEAR(distance(poses[i].shift(), sound[i].shift()), 0, 1e-9) << i;
    ASSERT_EQ(hasMoved[i], i % 97 == 1) << i;
  }
}

TEST(KeepShape, aBreakAndABendStay) {
  const auto were = line(30);
  auto poses = were;
  for (std::size_t i = 0; i < 15; ++i) poses[i].y += 2;
  for (std::size_t i = 0; i < 30; ++i) poses[i].x += 0.01 * double(i);
  const auto before = poses;
  keepShape(were, poses);
  for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(poses[i].y, before[i].y) << i;
  for (const std::size_t few : {0u, 1u, 2u}) {
    auto none = line(int(few));
    EXPECT_EQ(keepShape(line(int(few)), none).size(), few);
  }
}

}  // namespace
}  // namespace roomgraph
