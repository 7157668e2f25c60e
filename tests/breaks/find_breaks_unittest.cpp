#include "roomgraph/breaks/find_breaks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_building.h"
#include "drawn_drive.h"

namespace roomgraph {
namespace {

/** A building, and a drive through it. */
struct Drive {
  Grid grid = test::drawnBuilding(4, {});
  MapForAlignment map = mapForAlignment(grid, {});
  std::vector<Keyframe> frames = test::drawnDrive(grid);
};

const Drive& drive() {
  static const Drive the;
  return the;
}

ScanTrack trackOf(const std::vector<Keyframe>& frames) {
  const FollowedWalls known = followWalls(drive().map, drive().map, {{}}, {});
  return trackScans(scanWalls(frames), drive().map.patches, known, {}, drive().map, {});
}

std::vector<ScanBreak> breaksIn(const std::vector<Keyframe>& frames) {
  return findBreaks(scanWalls(frames), {trackOf(frames)}, {1}, {});
}

TEST(FindBreaks, aSoundRunHasNone) { EXPECT_TRUE(breaksIn(drive().frames).empty()); }

TEST(FindBreaks, aJumpOfTheHeadingIsFoundWithItsPlaceAndAngle) {
  for (const double turn : {0.06, -0.15}) {
    const auto found = breaksIn(test::broken(drive().frames, 18, turn, {}));
    ASSERT_EQ(found.size(), 1u) << turn;
    EXPECT_EQ(found[0].scan, 18u);
    EXPECT_NEAR(found[0].rotation, turn, 0.015);
    EXPECT_LT(found[0].shift, 0.15);
  }
}

TEST(FindBreaks, aJumpOfThePlaceIsFoundWithItsLength) {
  const auto found = breaksIn(test::broken(drive().frames, 20, 0, {0.2, 0.5}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].scan, 20u);
  EXPECT_NEAR(found[0].rotation, 0, 0.015);
  EXPECT_NEAR(found[0].shift, std::hypot(0.2, 0.5), 0.15);
}

TEST(FindBreaks, aDriftIsNoBreak) {
  std::vector<Keyframe> frames = drive().frames;
  for (std::size_t i = 1; i < frames.size(); ++i) frames = test::broken(frames, i, 0.004, {});
  EXPECT_TRUE(breaksIn(frames).empty());
}

/** Tracks of a drive on which nothing happens but in those named. */
std::vector<ScanTrack> tracksWithAJumpIn(const std::vector<std::size_t>& broken,
                                         std::size_t count) {
  std::vector<ScanTrack> tracks(count, ScanTrack(40, Transform2D{}));
  for (const std::size_t t : broken)
    for (std::size_t k = 20; k < 40; ++k) tracks[t][k] = Transform2D{0, 1.5, 0};
  return tracks;
}

TEST(FindBreaks, tracksOfMoreThanHalfOfTheWeightMustShowIt) {
  const std::vector<ScanWalls> scans(40);
  EXPECT_TRUE(findBreaks(scans, tracksWithAJumpIn({1}, 3), {1, 1, 1}, {}).empty());
  EXPECT_TRUE(findBreaks(scans, tracksWithAJumpIn({0}, 2), {1, 1}, {}).empty());
  const auto found = findBreaks(scans, tracksWithAJumpIn({0, 2}, 3), {1, 1, 1}, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].seenIn, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(found[0].shift, 1.5);
  EXPECT_EQ(findBreaks(scans, tracksWithAJumpIn({0}, 3), {1, 0.4, 0.4}, {}).size(), 1u)
      << "the first is trusted most";
}

TEST(FindBreaks, aScanThatIsLostForAMomentIsNoBreak) {
  std::vector<ScanTrack> tracks = tracksWithAJumpIn({}, 1);
  tracks[0][20] = Transform2D{3, 0, 0};
  EXPECT_TRUE(findBreaks(std::vector<ScanWalls>(40), tracks, {1}, {}).empty());
}

TEST(FindBreaks, withoutTracksThereAreNone) {
  EXPECT_TRUE(findBreaks({}, {}, {}, {}).empty());
  EXPECT_TRUE(findBreaks(std::vector<ScanWalls>(40), {ScanTrack(40)}, {1}, {}).empty());
}

}  // namespace
}  // namespace roomgraph
