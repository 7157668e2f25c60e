#include "roomgraph/breaks/find_breaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "drive_in_building.h"

namespace roomgraph {
namespace {

using test::driveInBuilding;

std::vector<ScanBreak> breaksIn(const std::vector<Keyframe>& frames) {
  ScanTrack track;
  for (const auto& pose : driveInBuilding().trackOf(frames)) track.push_back(pose.value());
  return findBreaks(scanWalls(frames), track, {});
}

TEST(FindBreaks, aSoundRunHasNone) { EXPECT_TRUE(breaksIn(driveInBuilding().frames).empty()); }

TEST(FindBreaks, aJumpOfTheHeadingIsFoundWithItsPlaceAndAngle) {
  for (const double turn : {0.06, -0.15}) {
    const auto found = breaksIn(test::broken(driveInBuilding().frames, 18, turn, {}));
    ASSERT_EQ(found.size(), 1u) << turn;
    EXPECT_EQ(found[0].scan, 18u);
    EXPECT_NEAR(found[0].rotation, turn, 0.015);
    EXPECT_LT(found[0].shift, 0.15);
  }
}

TEST(FindBreaks, aJumpOfThePlaceIsFoundWithItsLength) {
  const auto found = breaksIn(test::broken(driveInBuilding().frames, 20, 0, {0.2, 0.5}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].scan, 20u);
  EXPECT_NEAR(found[0].rotation, 0, 0.015);
  EXPECT_NEAR(found[0].shift, std::hypot(0.2, 0.5), 0.15);
}

TEST(FindBreaks, aDriftIsNoBreak) {
  std::vector<Keyframe> frames = driveInBuilding().frames;
  for (std::size_t i = 1; i < frames.size(); ++i) frames = test::broken(frames, i, 0.004, {});
  EXPECT_TRUE(breaksIn(frames).empty());
}

/** A track on which nothing happens but, if asked for, one jump. */
ScanTrack trackWith(std::optional<std::size_t> jump) {
  ScanTrack track(40, Transform2D{});
  for (std::size_t k = jump.value_or(40); k < 40; ++k) track[k] = Transform2D{0, 1.5, 0};
  return track;
}

TEST(FindBreaks, aJumpBetweenSteadyStretchesIsTheBreak) {
  const auto found = findBreaks(std::vector<ScanWalls>(40), trackWith(20), {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].scan, 20u);
  EXPECT_EQ(found[0].shift, 1.5);
}

TEST(FindBreaks, aScanThatIsLostForAMomentIsNoBreak) {
  ScanTrack track = trackWith(std::nullopt);
  track[20] = Transform2D{3, 0, 0};
  EXPECT_TRUE(findBreaks(std::vector<ScanWalls>(40), track, {}).empty());
}

TEST(FindBreaks, aRunWithoutScansHasNone) { EXPECT_TRUE(findBreaks({}, {}, {}).empty()); }

constexpr std::size_t kScans = 40;

/** The track of a run that lies off by `error` at each scan. */
ScanTrack trackOf(const std::function<Transform2D(std::size_t)>& error) {
  ScanTrack track;
  for (std::size_t k = 0; k < kScans; ++k) track.push_back(error(k));
  return track;
}

std::vector<ScanBreak> foundIn(const ScanTrack& track) {
  return findBreaks(std::vector<ScanWalls>(track.size()), track, {});
}

/** Shifts by 0.7 m at each of the scans 20, 21 and 22. */
Transform2D slips(std::size_t k) { return {0, 0.7 * std::clamp(double(k) - 19, 0.0, 3.0), 0}; }

TEST(FindBreaks, slipsThatFollowEachOtherAreOneBreak) {
  const auto found = foundIn(trackOf(slips));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].before, 19u);
  EXPECT_EQ(found[0].behind, 22u);
  EXPECT_NEAR(found[0].shift, 2.1, 1e-9);
  EXPECT_NEAR(found[0].rotation, 0, 1e-9);
}

TEST(FindBreaks, theFrameDoesNotMatter) {
  const Transform2D frame{30, -4, 2.1};
  const auto found = foundIn(trackOf([&](std::size_t k) { return frame * slips(k); }));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].before, 19u);
  EXPECT_NEAR(found[0].shift, 2.1, 1e-9);
}

TEST(FindBreaks, aSharpOneHasNoNeighboursInIt) {
  const auto found = foundIn(trackOf([](std::size_t k) {
    return Transform2D{0, 0, k < 17 ? 0.05 * (k % 2) : -0.6};
  }));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].scan, 17u);
  EXPECT_EQ(found[0].behind, 17u);
  EXPECT_NEAR(found[0].rotation, 0.6, 0.06);
}

TEST(FindBreaks, anUnsteadyRunHasItsOwn) {
  const ScanTrack track = trackOf([](std::size_t k) {
    return Transform2D{k < 20 ? 0.0 : 3.0, 0.25 * double(k % 3), 0};
  });
  ASSERT_EQ(foundIn(track).size(), 1u);
  EXPECT_EQ(foundIn(track)[0].scan, 20u);
}

TEST(FindBreaks, twoFarFromEachOtherAreTwo) {
  const auto found = foundIn(trackOf([](std::size_t k) {
    return Transform2D{k < 12 ? 0.0 : k < 28 ? 2.0 : 5.0, 0, 0};
  }));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].scan, 12u);
  EXPECT_EQ(found[1].scan, 28u);
}

TEST(FindBreaks, driftsAndWhatComesBackAreNone) {
  EXPECT_TRUE(foundIn(trackOf([](std::size_t k) {
                return Transform2D{0.2 * k, 0, 0.03 * k};
              })).empty());
  EXPECT_TRUE(foundIn(trackOf([](std::size_t k) {
                return Transform2D{k == 20 || k == 21 ? 4.0 : 0.0, 0, 0};
              })).empty());
}

}  // namespace
}  // namespace roomgraph
