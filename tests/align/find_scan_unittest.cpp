#include "roomgraph/align/find_scan.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

struct Seen {
  std::vector<LocalScan> scans = localScans(test::runOf(test::driveOnce()).scans);
  std::vector<Transform2D> poses = test::posesOf(test::driveOnce());
  WallMap map = scanMap(scans, poses, {7, 8, 9, 11, 12, 13}, 30);
};

TEST(FindScan, aScanIsFoundAtAnyTurn) {
  const Seen seen;
  for (const double turn : {0.0, 0.7, 2.0, M_PI}) {
    const Transform2D& right = seen.poses[10];
    const Transform2D around{right.x + 0.8, right.y - 0.5, wrappedAngle(right.phi + turn)};
    const auto found = findScan(seen.scans[10], seen.map, around, {M_PI, 1.5}, 2);
    ASSERT_FALSE(found.empty());
    EXPECT_LT(distance(found.front().pose.shift(), right.shift()), 0.1) << turn;
    EXPECT_NEAR(wrappedAngle(found.front().pose.phi - right.phi), 0, 0.02) << turn;
    EXPECT_GT(found.front().quality, 0.7);
    EXPECT_NEAR(found.front().known, fitAt(seen.scans[10], seen.map, right).known, 0.05);
  }
}

TEST(FindScan, aWrongPoseHasFewerOfTheWalls) {
  const Seen seen;
  const ScanFit right = fitAt(seen.scans[10], seen.map, seen.poses[10]);
  const Transform2D turned = seen.poses[10] * Transform2D{0, 0, 0.5};
  const ScanFit wrong = fitAt(seen.scans[10], seen.map, turned);
  EXPECT_GT(right.score, 20);
  EXPECT_LT(wrong.score, 0);
  EXPECT_LT(wrong.quality, right.quality - 0.3);
}

TEST(FindScan, aCorridorWithoutEndHoldsAScanInOneDirectionOnly) {
  LocalScan scan;
  for (int i = -50; i <= 50; ++i) {
    scan.walls.push_back({{0.1 * i, 1}, {0, -1}});
    scan.walls.push_back({{0.1 * i, -1}, {0, 1}});
  }
  const std::vector<Transform2D> here(1);
  const WallMap corridor = scanMap({scan}, here, {0}, 30);
  EXPECT_NEAR(fitAt(scan, corridor, {}).hold, 0, 1e-9);
  const Seen seen;
  EXPECT_GT(fitAt(seen.scans[10], seen.map, seen.poses[10]).hold, 0.05);
}

TEST(FindScan, inAnEmptyMapNothingIsFound) {
  const Seen seen;
  EXPECT_TRUE(findScan(seen.scans[10], WallMap{}, {}, {0.5, 1}, 3).empty());
  EXPECT_EQ(fitAt(seen.scans[10], WallMap{}, {}).quality, 0);
  EXPECT_TRUE(findScan({}, seen.map, seen.poses[10], {0.5, 1}, 3).empty());
}

}  // namespace
}  // namespace roomgraph
