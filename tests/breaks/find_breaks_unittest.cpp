#include "roomgraph/breaks/find_breaks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "drive_in_building.h"

namespace roomgraph {
namespace {

using test::driveInBuilding;

std::vector<ScanBreak> breaksIn(const std::vector<Keyframe>& frames) {
  return findBreaks(scanWalls(frames), driveInBuilding().trackOf(frames), {});
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

TEST(FindBreaks, whatWasNotFoundHasNone) {
  EXPECT_TRUE(findBreaks({}, {}, {}).empty());
  EXPECT_TRUE(findBreaks(std::vector<ScanWalls>(40), ScanTrack(40), {}).empty());
}

}  // namespace
}  // namespace roomgraph
