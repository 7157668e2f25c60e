#include "roomgraph/align/step_hold.h"

#include <gtest/gtest.h>

#include "drawn_drive.h"
#include "sample_drives.h"

namespace roomgraph {
namespace {

TEST(StepHold, isLostWhereTheMapIsTorn) {
  const auto scans = scanWalls(test::broken(test::driveOnce(), 20, 2.2, {3, 4}));
  ASSERT_GT(scans.size(), 30u);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    if (k == 20)
      EXPECT_LT(stepHold(scans, k), 0.5);
    else
      EXPECT_EQ(stepHold(scans, k), 1) << k;
  }
}

TEST(StepHold, oneScanThatSeesPeopleOnlyDoesNotPartTheNextFromTheLast) {
  auto scans = scanWalls(test::driveOnce());
  for (WallPoint& wall : scans[20].walls) wall.place = wall.place + Point{50, 50};
  EXPECT_LT(stepHold(scans, 20), 0.5);
  EXPECT_EQ(stepHold(scans, 21), 1);
}

TEST(StepHold, whereThereIsNoStepItHolds) {
  EXPECT_EQ(stepHold({}, 0), 1);
  EXPECT_EQ(stepHold(scanWalls(test::driveOnce()), 1000), 1);
}

TEST(StepHold, wallsInCommonAreNearAndFaceAlike) {
  ScanWalls one, other;
  for (int i = 0; i < 8; ++i) one.walls.push_back({{double(i), 0}, {1, 0}});
  other.walls = {{{0, 0.1}, {1, 0}}, {{1, 0}, {-1, 0}}, {{2, 0.5}, {1, 0}}};
  EXPECT_DOUBLE_EQ(stepHold({other, one}, 1), 0.125 / 0.15);
  EXPECT_EQ(stepHold({one, {}}, 1), 1);
}

}  // namespace
}  // namespace roomgraph
