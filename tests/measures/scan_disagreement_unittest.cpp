#include "scan_disagreement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_building.h"
#include "drawn_drive.h"

namespace roomgraph {
namespace {

/** A drive to the end of a corridor and back again; the way back may be shifted as a whole. */
std::vector<ScanWalls> thereAndBack(Point shift) {
  static const std::vector<Keyframe> there =
      test::drawnDrive(test::drawnBuilding(4, {0.3, 0.2, 0.1}));
  std::vector<Keyframe> frames = there;
  for (std::size_t i = there.size(); i-- > 0;) {
    Keyframe frame = there[i];
    frame.pose.x += shift.x, frame.pose.y += shift.y;
    frames.push_back(frame);
  }
  return scanWalls(frames);
}

TEST(ScanDisagreement, aTrueDriveHasLittle) {
  const Figure found = scanDisagreement(thereAndBack({}));
  EXPECT_LT(found.value.value(), 0.06);
  EXPECT_GT(found.support, 30);
}

TEST(ScanDisagreement, growsWithTheShiftOfTheSecondVisit) {
  const double small = scanDisagreement(thereAndBack({0.1, 0.15})).value.value();
  const double large = scanDisagreement(thereAndBack({0.3, 0.4})).value.value();
  EXPECT_GT(small, 0.06);
  EXPECT_GT(large, small + 0.05);
  EXPECT_LE(large, 0.5);
}

TEST(ScanDisagreement, theSameSceneAMomentLaterTellsNothing) {
  std::vector<ScanWalls> scans = thereAndBack({});
  scans.resize(9);  // 4 m of path
  const Figure found = scanDisagreement(scans);
  EXPECT_FALSE(found.value);
  EXPECT_EQ(found.support, 0);
}

TEST(ScanDisagreement, withoutScansThereIsNone) {
  EXPECT_FALSE(scanDisagreement({}).value);
  EXPECT_FALSE(scanDisagreement(std::vector<ScanWalls>(3)).value);
}

TEST(ScanDisagreement, theFrameOfTheRunChangesLittle) {
  std::vector<ScanWalls> scans = thereAndBack({0.1, 0.15});
  const double here = scanDisagreement(scans).value.value();
  const Transform2D motion{50, -20, 2};
  for (ScanWalls& scan : scans) {
    scan.pose = motion * scan.pose;
    for (WallPoint& wall : scan.walls)
      wall.place = motion(wall.place), wall.normal = turned(wall.normal, motion.phi);
  }
  const Figure there = scanDisagreement(scans);
  EXPECT_NEAR(there.value.value(), here, 1e-6);
}

TEST(ScanDisagreement, drivenBackwardsIsTheSameDrive) {
  std::vector<ScanWalls> scans = thereAndBack({0.1, 0.15});
  const Figure forth = scanDisagreement(scans);
  std::reverse(scans.begin(), scans.end());
  const Figure back = scanDisagreement(scans);
  EXPECT_NEAR(back.value.value(), forth.value.value(), 1e-9);
  EXPECT_EQ(back.support, forth.support);
}

TEST(ScanDisagreement, wallsThatFaceAwayAreNotTheSame) {
  std::vector<ScanWalls> scans = thereAndBack({});
  const std::size_t half = scans.size() / 2;
  for (std::size_t k = half; k < scans.size(); ++k)
    for (WallPoint& wall : scans[k].walls) wall.normal = -1.0 * wall.normal;
  const Figure found = scanDisagreement(scans);
  EXPECT_LT(found.support, scanDisagreement(thereAndBack({})).support);
}

}  // namespace
}  // namespace roomgraph
