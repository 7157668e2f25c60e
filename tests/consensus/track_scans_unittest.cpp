#include "roomgraph/consensus/track_scans.h"

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

std::vector<std::optional<Transform2D>> trackOf(const std::vector<Keyframe>& frames) {
  const FollowedWalls known = followWalls(drive().map, drive().map, {{}}, {});
  return trackScans(scanWalls(frames), drive().map.patches, known, {{}}, drive().map, {});
}

TEST(TrackScans, eachScanLiesWhereItWasTaken) {
  const auto track = trackOf(drive().frames);
  ASSERT_GT(track.size(), 30u);
  for (std::size_t i = 0; i < track.size(); ++i) {
    ASSERT_TRUE(track[i]) << i;
    EXPECT_NEAR(track[i]->phi, 0, 0.02);
    const Point at = drive().frames[i].pose.shift();
    EXPECT_LT(distance((*track[i])(at), at), 0.1);
  }
}

TEST(TrackScans, whatIsNotInTheMapIsNotFound) {
  const MapForAlignment other = mapForAlignment(test::squareHall({40, 40, 0}), {});
  for (const auto& pose :
       trackScans(scanWalls(drive().frames), drive().map.patches, {}, {{}}, other, {}))
    EXPECT_FALSE(pose);
  EXPECT_TRUE(trackScans({}, {}, {}, {}, other, {}).empty());
}

TEST(TrackScans, atAnyTearTheScansAreFoundAgain) {
  // Not by a quarter turn: rooms as square as these look the same then.
  for (const double turn : {0.3, 2.2, M_PI}) {
    const std::size_t cut = 18;
    const std::vector<Keyframe> frames = test::broken(drive().frames, cut, turn, {2, -1});
    const auto track = trackOf(frames);
    std::size_t found = 0;
    for (std::size_t i = 0; i < track.size(); ++i) {
      if (!track[i]) continue;
      const Point at = drive().frames[i].pose.shift();
      found += distance((*track[i])(frames[i].pose.shift()), at) < 0.15;
    }
    EXPECT_GE(found + 3, track.size()) << turn;
  }
}

}  // namespace
}  // namespace roomgraph
