#include "roomgraph/align/scan_walls.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** A scan to the right of a wall along x = 3 of the robot's frame, and what it met behind a gap. */
Keyframe facingAWall(const Transform2D& pose) {
  Keyframe frame;
  frame.pose = pose, frame.number = 7, frame.time = 12.5, frame.scanId = 42;
  for (double y = -2; y < 2; y += 0.05) frame.ends.push_back({3, y});
  return frame;
}

TEST(ScanWalls, wallsLieWhereTheBeamsEndAndFaceTheRobot) {
  const Transform2D pose{10, -4, 2};
  const std::vector<ScanWalls> scans = scanWalls({facingAWall(pose)});
  ASSERT_EQ(scans.size(), 1u);
  ASSERT_GT(scans[0].walls.size(), 50u);
  for (const WallPoint& wall : scans[0].walls) {
    EXPECT_NEAR(pose.inverse()(wall.place).x, 3, 1e-9);
    EXPECT_NEAR(dot(wall.normal, turned({-1, 0}, pose.phi)), 1, 1e-9);
  }
  EXPECT_EQ(scans[0].robot().x, 10);
}

TEST(ScanWalls, aScanKeepsWhatItsKeyFrameSays) {
  const ScanWalls scan = scanWalls({facingAWall({})}).at(0);
  EXPECT_EQ(scan.keyFrame, 7u);
  EXPECT_EQ(scan.time, 12.5);
  EXPECT_EQ(scan.scanId, 42u);
  EXPECT_EQ(scan.axes.has_value(), scanAxes(facingAWall({}).ends).has_value());
}

TEST(ScanWalls, thereAreAtMostAsManyAsAskedForFromAllOfTheScan) {
  const auto walls = scanWalls({facingAWall({})}, 10).at(0).walls;
  EXPECT_LE(walls.size(), 10u);
  EXPECT_GE(walls.size(), 8u);
  EXPECT_LT(walls.front().place.y, -1.5);
  EXPECT_GT(walls.back().place.y, 1.5);
}

TEST(ScanWalls, beamsThatMeetNothingNearTheirNeighboursAreLeftOut) {
  Keyframe frame;
  frame.ends = {{3, -1}, {3, -0.9}, {3, -0.8}, {9, 0}, {1, 0.3}, {5, 1}};
  const auto walls = scanWalls({frame}).at(0).walls;
  ASSERT_EQ(walls.size(), 1u) << "only the second has both neighbours on its wall";
  EXPECT_NEAR(walls[0].place.y, -0.9, 1e-9);
}

TEST(ScanWalls, farBeamsMayLieFurtherApart) {
  const auto wallsAt = [](double range) {
    Keyframe frame;
    frame.ends = {{range, -0.5}, {range, 0}, {range, 0.5}};
    return scanWalls({frame}).at(0).walls.size();
  };
  EXPECT_EQ(wallsAt(2), 0u);
  EXPECT_EQ(wallsAt(8), 1u);
}

TEST(ScanWalls, emptyScansStay) {
  EXPECT_TRUE(scanWalls({}).empty());
  const std::vector<ScanWalls> scans = scanWalls({Keyframe{}, facingAWall({})});
  ASSERT_EQ(scans.size(), 2u) << "numbers of scans are those of key frames";
  EXPECT_TRUE(scans[0].walls.empty());
}

TEST(ScanWalls, theWayDrivenGrowsFromScanToScan) {
  std::vector<ScanWalls> scans(3);
  scans[1].pose = {3, 4, 1}, scans[2].pose = {3, 2, 0};
  EXPECT_EQ(drivenWays(scans), (std::vector<double>{0, 5, 7}));
  EXPECT_TRUE(drivenWays({}).empty());
}

}  // namespace
}  // namespace roomgraph
