#include "roomgraph/align/scan_map.h"

#include <gtest/gtest.h>

#include "roomgraph/align/align_maps.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/align/wall_map.h"
#include "sample_drives.h"

namespace roomgraph {
namespace {

TEST(ScanMap, aScanFindsItsOwnWallsInItsMap) {
  const roomgraph::Run run = test::runOf(test::driveOnce());
  const std::vector<LocalScan> scans = localScans(run.scans);
  const WallMap map = scanMap(scans, test::posesOf(test::driveOnce()), {10}, 30);
  ASSERT_EQ(map.walls.size(), scans[10].walls.size());
  for (const WallPoint& wall : run.scans[10].walls) {
    const std::size_t cell = cellIndexAt(map.frame, wall.place);
    EXPECT_EQ(map.states[cell], State::occupied);
    const WallPoint* nearest = nearestWall(map, wall.place, wall.normal);
    ASSERT_TRUE(nearest);
    EXPECT_LT(distance(nearest->place, wall.place), 0.2);
  }
}

TEST(ScanMap, beamsClearWhatTheyCross) {
  const std::vector<LocalScan> scans = localScans(test::runOf(test::driveOnce()).scans);
  const WallMap map = scanMap(scans, test::posesOf(test::driveOnce()), {10}, 30);
  const Point robot = test::driveOnce()[10].pose.shift();
  EXPECT_EQ(map.states[cellIndexAt(map.frame, robot)], State::free);
  EXPECT_EQ(map.states[0], State::unknown);  // the margin
}

TEST(ScanMap, wallsOutOfRangeAreLeftOut) {
  const std::vector<LocalScan> scans = localScans(test::runOf(test::driveOnce()).scans);
  const Point robot = test::driveOnce()[10].pose.shift();
  const WallMap map = scanMap(scans, test::posesOf(test::driveOnce()), {10}, 4);
  EXPECT_FALSE(map.walls.empty());
  for (const WallPoint& wall : map.walls) EXPECT_LT(distance(wall.place, robot), 4);
  EXPECT_TRUE(scanMap(scans, test::posesOf(test::driveOnce()), {}, 30).walls.empty());
  EXPECT_TRUE(scanMap(scans, test::posesOf(test::driveOnce()), {10}, 0.01).walls.empty());
}

TEST(StretchMap, isAlignedLikeTheMapOfARun) {
  const Transform2D there{5, -3, 2.5};
  const WallMap building = wallMap(test::drawnBuilding(4, there));
  const auto scans = test::runOf(test::driveOnce()).scans;
  const Alignment found = alignMaps(building, stretchMap(scans, 5, 30));
  EXPECT_NEAR(wrappedAngle(found.pose.phi - there.phi), 0, 0.03);
  EXPECT_LT(distance(found.pose(scans[10].robot()), there(scans[10].robot())), 0.2);
}

TEST(StretchMap, ofScansWithoutWallsHasNone) {
  EXPECT_TRUE(stretchMap({ScanWalls{}, ScanWalls{}}, 0, 2).walls.empty());
}

}  // namespace
}  // namespace roomgraph
