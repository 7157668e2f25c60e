#include "roomgraph/consensus/track_scans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "drive_in_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

using test::driveInBuilding;
using test::trackOnce;

TEST(TrackScans, eachScanLiesWhereItWasTaken) {
  const auto track = driveInBuilding().trackOf(driveInBuilding().frames);
  ASSERT_GT(track.size(), 30u);
  for (std::size_t i = 0; i < track.size(); ++i) {
    ASSERT_TRUE(track[i]) << i;
    EXPECT_NEAR(track[i]->phi, 0, 0.02);
    const Point at = driveInBuilding().frames[i].pose.shift();
    EXPECT_LT(distance((*track[i])(at), at), 0.1);
  }
}

TEST(TrackScans, whatIsNotInTheMapIsNotFound) {
  const WallMap other = wallMap(test::squareHall({40, 40, 0}));
  for (const auto& pose : trackOnce(scanWalls(driveInBuilding().frames),
                                    driveInBuilding().map.patches, {}, {{}}, other))
    EXPECT_FALSE(pose);
  EXPECT_TRUE(trackOnce({}, {}, {}, {}, other).empty());
}

TEST(TrackScans, atAnyTearTheScansAreFoundAgain) {
  // Not by a quarter turn: rooms as square as these look the same then.
  for (const double turn : {0.3, 2.2, M_PI}) {
    const std::size_t cut = 18;
    const std::vector<Keyframe> frames = test::broken(driveInBuilding().frames, cut, turn, {2, -1});
    const auto track = driveInBuilding().trackOf(frames);
    std::size_t found = 0;
    for (std::size_t i = 0; i < track.size(); ++i) {
      if (!track[i]) continue;
      const Point at = driveInBuilding().frames[i].pose.shift();
      found += distance((*track[i])(frames[i].pose.shift()), at) < 0.15;
    }
    EXPECT_GE(found + 3, track.size()) << turn;
  }
}

TEST(TrackScans, aShortTornEndIsFoundWhereItWasLookedForAndTheRunsOwnScansPart) {
  const test::DriveInBuilding& drive = driveInBuilding();
  const std::size_t cut = drive.frames.size() - 4;
  const std::vector<Keyframe> frames = test::broken(drive.frames, cut, 40 * M_PI / 180, {0.3, 0.2});
  const Transform2D there = drive.frames[cut].pose * frames[cut].pose.inverse();
  for (const auto& lost : {std::vector<Transform2D>{}, {there}}) {
    TrackedFits fits;
    const auto track =
        trackScans(scanWalls(frames), drive.map.patches, {}, {{{}}, lost}, drive.map, fits);
    for (std::size_t i = cut; i < track.size(); ++i) {
      const Point at = drive.frames[i].pose.shift();
      const bool isFound = track[i] && distance((*track[i])(frames[i].pose.shift()), at) < 0.15;
      EXPECT_EQ(isFound, !lost.empty()) << i;
    }
  }
}

/** The share of the scans that lie where they were taken, once `back` has carried them there. */
double shareFound(const std::vector<std::optional<Transform2D>>& track,
                  const std::vector<Keyframe>& driven, const Transform2D& back) {
  double found = 0;
  for (std::size_t i = 0; i < track.size(); ++i)
    if (track[i])
      found += distance(back((*track[i])(driven[i].pose.shift())),
                        driveInBuilding().frames[i].pose.shift()) < 0.15;
  return found / double(track.size());
}

TEST(TrackScans, theFrameOfTheRunChangesNothing) {
  const Transform2D motion{31, -12, 2.1};
  const auto driven = test::moved(driveInBuilding().frames, motion);
  const auto track =
      trackOnce(scanWalls(driven), {}, {}, {motion.inverse()}, driveInBuilding().map);
  EXPECT_GE(shareFound(track, driven, {}), 0.95);
}

TEST(TrackScans, theFrameOfTheMapChangesNothing) {
  const Transform2D motion{-9, 40, -1.2};
  const WallMap there = wallMap(test::drawnBuilding(4, motion));
  const auto& driven = driveInBuilding().frames;
  const auto track = trackOnce(scanWalls(driven), {}, {}, {motion}, there);
  EXPECT_GE(shareFound(track, driven, motion.inverse()), 0.9);
}

TEST(TrackScans, ofSeveralWholesTheLikeliestComesFirst) {
  const auto& drive = driveInBuilding();
  const Transform2D wrong{3, 1, 2};
  const auto track = trackOnce(scanWalls(drive.frames), {}, {}, {{}, wrong}, drive.map);
  EXPECT_GE(shareFound(track, drive.frames, {}), 0.95);
  const auto other = trackOnce(scanWalls(drive.frames), {}, {}, {wrong, {}}, drive.map);
  EXPECT_GE(shareFound(other, drive.frames, {}), 0.95) << "what fits goes before what is likely";
}

TEST(TrackScans, aBlindStretchIsNotFoundAndWhatIsBehindItIs) {
  const auto& drive = driveInBuilding();
  std::vector<ScanWalls> scans = scanWalls(drive.frames);
  for (std::size_t k = 10; k < 15; ++k) scans[k].walls.clear();
  for (std::size_t k = 25; k < 27; ++k) scans[k].walls.resize(15);  // too few to tell
  const auto track = trackOnce(scans, {}, {}, {{}}, drive.map);
  for (std::size_t k = 0; k < track.size(); ++k) {
    const bool isBlind = (k >= 10 && k < 15) || (k >= 25 && k < 27);
    EXPECT_EQ(track[k].has_value(), !isBlind) << k;
  }
}

TEST(TrackScans, whatEarlierTracksFoundChangesNothing) {
  const auto& drive = driveInBuilding();
  const std::vector<ScanWalls> scans = scanWalls(drive.frames);
  const Transform2D wrong{3, 1, 2};
  TrackedFits fits;
  trackScans(scans, {}, {}, {{wrong}, {}}, drive.map, fits);
  const auto once = trackOnce(scans, {}, {}, {wrong, {}}, drive.map);
  const auto again = trackScans(scans, {}, {}, {{wrong, {}}, {}}, drive.map, fits);
  EXPECT_GE(shareFound(again, drive.frames, {}), 0.95);
  for (std::size_t k = 0; k < once.size(); ++k) {
    ASSERT_EQ(again[k].has_value(), once[k].has_value()) << k;
    if (once[k]) {
      EXPECT_EQ(again[k]->shift(), once[k]->shift()) << k;
    }
  }
}

TEST(TrackScans, oneScanIsTracked) {
  const auto& drive = driveInBuilding();
  const std::vector<Keyframe> one{drive.frames[12]};
  const auto track = trackOnce(scanWalls(one), {}, {}, {{}}, drive.map);
  ASSERT_EQ(track.size(), 1u);
  ASSERT_TRUE(track[0]);
  EXPECT_LT(distance((*track[0])(one[0].pose.shift()), one[0].pose.shift()), 0.1);
}

TEST(TrackScans, moreBlindScansThanItRemembersDoNotLoseTheRest) {
  const auto& drive = driveInBuilding();
  std::vector<ScanWalls> scans = scanWalls(drive.frames);
  for (std::size_t k = 8; k < 20; ++k) scans[k].walls.clear();
  const auto track = trackOnce(scans, {}, {}, {{}}, drive.map);
  EXPECT_TRUE(track[7]);
  for (std::size_t k = 20; k < track.size(); ++k) EXPECT_TRUE(track[k]) << k;
}

}  // namespace
}  // namespace roomgraph
