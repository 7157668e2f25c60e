#include "beams_through_walls.h"

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

}  // namespace
}  // namespace roomgraph
