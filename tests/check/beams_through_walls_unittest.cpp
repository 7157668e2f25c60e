#include "roomgraph/check/beams_through_walls.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

double shareThrough(const std::vector<Keyframe>& frames) {
  const auto beams =
      beamsThroughWalls(localScans(test::runOf(frames).scans), test::posesOf(frames));
  EXPECT_GT(beams.walls, 100u);
  return double(beams.through) / double(beams.walls);
}

TEST(BeamsThroughWalls, ofASoundRunHardlyAnyGoesThrough) {
  EXPECT_LT(shareThrough(test::driveForthAndBack()), 0.02);
}

TEST(BeamsThroughWalls, whereTheWayBackIsDrawnElsewhereTheyDo) {
  EXPECT_GT(shareThrough(test::broken(test::driveForthAndBack(), 50, 0, {0.5, 1.5})), 0.2);
}

TEST(BeamsThroughWalls, scansThatSeeThroughMostWallsOfAnotherTimeAreNamedWithIt) {
  const auto overlaidIn = [](const std::vector<Keyframe>& frames) {
    const auto scans = localScans(test::runOf(frames).scans);
    return beamsThroughWalls(scans, test::posesOf(frames)).overlaid;
  };
  EXPECT_TRUE(overlaidIn(test::driveForthAndBack()).empty());
  const auto overlaid = overlaidIn(test::broken(test::driveForthAndBack(), 50, 0, {0.5, 1.5}));
  ASSERT_FALSE(overlaid.empty());
  for (const ScanPair& pair : overlaid) EXPECT_TRUE(pair.one < 50 && pair.other >= 50);
}

TEST(BeamsThroughWalls, whatWasDrivenOnceIsHeldAgainstNothing) {
  const auto& once = test::driveOnce();
  const std::vector<Keyframe> half(once.begin(), once.begin() + 20);
  EXPECT_EQ(beamsThroughWalls(localScans(test::runOf(half).scans), test::posesOf(half)).walls, 0u);
}

/** A way of forty scans, a metre each. */
roomgraph::Run runOfWay() {
  roomgraph::Run run;
  for (std::size_t k = 0; k < 40; ++k) {
    run.scans.emplace_back();
    run.scans[k].keyFrame = 10 + k;
    run.scans[k].pose = {double(k), 0, 0};
  }
  return run;
}

BeamsThroughWalls overlaid(const std::vector<ScanPair>& pairs) {
  BeamsThroughWalls beams;
  beams.overlaid = pairs;
  return beams;
}

const std::vector<ScanPair> kSix{{2, 30}, {3, 29}, {4, 28}, {5, 27}, {5, 28}, {4, 29}};

TEST(FindWelded, tellsBothTimesOfWhatSeesThroughEachOther) {
  const auto places = findWelded(runOfWay(), overlaid(kSix), overlaid(kSix));
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places[0].one.first, 12u);
  EXPECT_EQ(places[0].one.last, 15u);
  EXPECT_EQ(places[0].one.keyFrame, 15u);
  EXPECT_EQ(places[0].other.first, 37u);
  EXPECT_EQ(places[0].other.last, 40u);
}

TEST(FindWelded, whatTheRunPartsIfItAgreesWithItselfIsNotOne) {
  EXPECT_TRUE(findWelded(runOfWay(), overlaid(kSix), overlaid({})).empty());
  EXPECT_TRUE(findWelded(runOfWay(), overlaid({}), overlaid(kSix)).empty()) << "it is not drawn so";
  auto later = kSix;
  for (ScanPair& pair : later) pair.other -= 12;
  EXPECT_TRUE(findWelded(runOfWay(), overlaid(kSix), overlaid(later)).empty()) << "of another time";
}

TEST(FindWelded, aFewScansMayHaveSeenPeople) {
  const std::vector<ScanPair> five(kSix.begin() + 1, kSix.end());
  EXPECT_TRUE(findWelded(runOfWay(), overlaid(five), overlaid(kSix)).empty());
  EXPECT_TRUE(findWelded(runOfWay(), overlaid(kSix), overlaid(five)).empty());
  const auto same = overlaid(std::vector<ScanPair>(9, {2, 30}));
  EXPECT_TRUE(findWelded(runOfWay(), same, same).empty());
}

TEST(FindWelded, theLargestIsFirst) {
  std::vector<ScanPair> pairs = kSix;
  for (const ScanPair& pair : kSix) pairs.push_back({pair.one, pair.other - 12});
  pairs.push_back({4, 16});
  const auto places = findWelded(runOfWay(), overlaid(pairs), overlaid(pairs));
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].other.last, 28u);
  EXPECT_EQ(places[1].other.last, 40u);
}

TEST(BeamsThroughWalls, moreThanAreDrawnRefuteWhereARunWouldAgree) {
  EXPECT_TRUE(seesThroughMore({100, 10, {}}, {120, 18, {}}));
  EXPECT_FALSE(seesThroughMore({100, 10, {}}, {120, 16, {}}));
  EXPECT_FALSE(seesThroughMore({0, 0, {}}, {120, 60, {}})) << "nothing to compare with";
}

}  // namespace
}  // namespace roomgraph
