#include "roomgraph/consensus/track_scans.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drive_in_building.h"

namespace roomgraph {
namespace {

using test::driveInBuilding;

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
  const MapForAlignment other = mapForAlignment(test::squareHall({40, 40, 0}), {});
  for (const auto& pose : trackScans(scanWalls(driveInBuilding().frames),
                                     driveInBuilding().map.patches, {}, {{}}, other, {}))
    EXPECT_FALSE(pose);
  EXPECT_TRUE(trackScans({}, {}, {}, {}, other, {}).empty());
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

}  // namespace
}  // namespace roomgraph
