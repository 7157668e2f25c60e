#include "roomgraph/check/find_scan.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

struct Seen {
  std::vector<LocalScan> scans = localScans(test::runOf(test::driveOnce()).scans);
  std::vector<Transform2D> poses = test::posesOf(test::driveOnce());
  WallMap map = scanMap(scans, poses, {8, 9, 11, 12}, 30);
};

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
