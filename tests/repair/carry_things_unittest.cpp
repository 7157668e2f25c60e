#include "roomgraph/repair/carry_things.h"

#include <gtest/gtest.h>

#include "repaired_site.h"

namespace roomgraph {
namespace {

CarriedPlace placeOf(CarryState state, double error, const std::string& reason = "") {
  CarriedPlace place;
  place.pose = Transform2D{1, 0, 0}, place.state = state, place.error = error,
  place.reason = reason;
  return place;
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
  EXPECT_EQ(things[3].state, CarryState::carried);
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

}  // namespace
}  // namespace roomgraph
