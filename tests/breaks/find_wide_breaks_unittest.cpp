#include "find_wide_breaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "roomgraph/breaks/find_breaks.h"

namespace roomgraph {
namespace {

constexpr std::size_t kScans = 40;

/** The track of a run that lies off by `error` at each scan. */
ScanTrack trackOf(const std::function<Transform2D(std::size_t)>& error) {
  ScanTrack track;
  for (std::size_t k = 0; k < kScans; ++k) track.push_back(error(k));
  return track;
}

std::vector<ScanBreak> wideIn(const ScanTrack& track) {
  return findWideBreaks(std::vector<ScanWalls>(track.size()), track, {});
}

/** Shifts by 0.7 m at each of the scans 20, 21 and 22. */
Transform2D slips(std::size_t k) { return {0, 0.7 * std::clamp(double(k) - 19, 0.0, 3.0), 0}; }

TEST(FindWideBreaks, slipsThatFollowEachOtherAreOneBreak) {
  const auto found = wideIn(trackOf(slips));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].before, 19u);
  EXPECT_EQ(found[0].behind, 22u);
  EXPECT_NEAR(found[0].shift, 2.1, 1e-9);
  EXPECT_NEAR(found[0].rotation, 0, 1e-9);
}

TEST(FindWideBreaks, theFrameDoesNotMatter) {
  const Transform2D frame{30, -4, 2.1};
  const auto found = wideIn(trackOf([&](std::size_t k) { return frame * slips(k); }));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].before, 19u);
  EXPECT_NEAR(found[0].shift, 2.1, 1e-9);
}

TEST(FindWideBreaks, aSharpOneHasNoNeighboursInIt) {
  const auto found = wideIn(trackOf([](std::size_t k) {
    return Transform2D{0, 0, k < 17 ? 0.05 * (k % 2) : -0.6};
  }));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].scan, 17u);
  EXPECT_EQ(found[0].behind, 17u);
  EXPECT_NEAR(found[0].rotation, 0.6, 0.06);
}

TEST(FindWideBreaks, anUnsteadyRunHasItsOwn) {
  const ScanTrack track = trackOf([](std::size_t k) {
    return Transform2D{k < 20 ? 0.0 : 3.0, 0.25 * double(k % 3), 0};
  });
  ASSERT_EQ(wideIn(track).size(), 1u);
  EXPECT_EQ(wideIn(track)[0].scan, 20u);
  EXPECT_EQ(findBreaks(std::vector<ScanWalls>(kScans), track, {}).size(), 1u);
}

TEST(FindWideBreaks, twoFarFromEachOtherAreTwo) {
  const auto found = wideIn(trackOf([](std::size_t k) {
    return Transform2D{k < 12 ? 0.0 : k < 28 ? 2.0 : 5.0, 0, 0};
  }));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].scan, 28u);  // the sharper one
  EXPECT_EQ(found[1].scan, 12u);
}

TEST(FindWideBreaks, driftsAndWhatComesBackAreNone) {
  EXPECT_TRUE(wideIn(trackOf([](std::size_t k) {
                return Transform2D{0.2 * k, 0, 0.03 * k};
              })).empty());
  EXPECT_TRUE(wideIn(trackOf([](std::size_t k) {
                return Transform2D{k == 20 || k == 21 ? 4.0 : 0.0, 0, 0};
              })).empty());
}

TEST(FindWideBreaks, whatWasNotFoundIsSkipped) {
  ScanTrack track = trackOf([](std::size_t k) { return Transform2D{k < 20 ? 0.0 : 2.0, 0, 0}; });
  track[20] = track[21] = std::nullopt;
  const auto found = wideIn(track);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].before, 19u);
  EXPECT_EQ(found[0].behind, 22u);
  EXPECT_TRUE(wideIn({}).empty());
  EXPECT_TRUE(wideIn(ScanTrack(kScans)).empty());
}

}  // namespace
}  // namespace roomgraph
