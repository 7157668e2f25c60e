#include "find_welded.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

/** A way of forty scans, a metre each. */
roomgraph::Run way() {
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
  const auto places = findWelded(way(), overlaid(kSix), overlaid(kSix));
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places[0].one.first, 12u);
  EXPECT_EQ(places[0].one.last, 15u);
  EXPECT_EQ(places[0].one.keyFrame, 15u);
  EXPECT_EQ(places[0].other.first, 37u);
  EXPECT_EQ(places[0].other.last, 40u);
}

TEST(FindWelded, whatTheRunPartsIfItAgreesWithItselfIsNotOne) {
  EXPECT_TRUE(findWelded(way(), overlaid(kSix), overlaid({})).empty());
  EXPECT_TRUE(findWelded(way(), overlaid({}), overlaid(kSix)).empty()) << "it is not drawn so";
  auto later = kSix;
  for (ScanPair& pair : later) pair.other -= 12;
  EXPECT_TRUE(findWelded(way(), overlaid(kSix), overlaid(later)).empty()) << "of another time";
}

TEST(FindWelded, aFewScansMayHaveSeenPeople) {
  const std::vector<ScanPair> five(kSix.begin() + 1, kSix.end());
  EXPECT_TRUE(findWelded(way(), overlaid(five), overlaid(kSix)).empty());
  EXPECT_TRUE(findWelded(way(), overlaid(kSix), overlaid(five)).empty());
  const auto same = overlaid(std::vector<ScanPair>(9, {2, 30}));
  EXPECT_TRUE(findWelded(way(), same, same).empty());
}

TEST(FindWelded, theLargestIsFirst) {
  std::vector<ScanPair> pairs = kSix;
  for (const ScanPair& pair : kSix) pairs.push_back({pair.one, pair.other - 12});
  pairs.push_back({4, 16});
  const auto places = findWelded(way(), overlaid(pairs), overlaid(pairs));
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].other.last, 28u);
  EXPECT_EQ(places[1].other.last, 40u);
}

}  // namespace
}  // namespace roomgraph
