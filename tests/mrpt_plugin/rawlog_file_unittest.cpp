#include <gtest/gtest.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <cmath>

#include "TestFolder.h"
#include "roomgraph/mrpt_plugin/mrpt_files.h"
#include "sample_drive.h"

namespace roomgraph {
namespace {

/** The log as MRPT reads it from a file. */
mrpt::obs::CRawlog readBack(const std::string& bytes) {
  const TestFolder folder;
  mrpt::obs::CRawlog log;
  EXPECT_TRUE(log.loadFromRawLogFile(folder.write("a.rawlog", bytes)));
  return log;
}

TEST(RawlogBytes, theActionsAddUpToThePosesOfTheScans) {
  const std::vector<PlacedScan> drive = test::sampleDrive(12);
  const mrpt::obs::CRawlog log = readBack(rawlogBytes(drive));
  ASSERT_EQ(log.size(), 24u);
  mrpt::poses::CPose2D pose;
  for (std::size_t k = 0; k < drive.size(); ++k) {
    mrpt::poses::CPose3D way;
    ASSERT_TRUE(log.getAsAction(2 * k)->getFirstMovementEstimationMean(way)) << k;
    pose = pose + mrpt::poses::CPose2D(way);
    EXPECT_NEAR(pose.x(), drive[k].from.x(), 1e-9) << k;
    EXPECT_NEAR(pose.y(), drive[k].from.y(), 1e-9) << k;
    EXPECT_NEAR(std::remainder(pose.phi() - drive[k].from.yaw(), 2 * M_PI), 0, 1e-9) << k;
  }
}

TEST(RawlogBytes, eachScanComesBackWhole) {
  const std::vector<PlacedScan> drive = test::sampleDrive(3);
  const mrpt::obs::CRawlog log = readBack(rawlogBytes(drive));
  ASSERT_EQ(log.size(), 6u);
  for (std::size_t k = 0; k < drive.size(); ++k) {
    const auto scan = log.getAsObservations(2 * k + 1)
                          ->getObservationByClass<mrpt::obs::CObservation2DRangeScan>();
    ASSERT_TRUE(scan) << k;
    EXPECT_EQ(scan->timestamp, drive[k].scan.time);
    EXPECT_EQ(scan->sensorLabel, drive[k].scan.label);
    EXPECT_EQ(scan->aperture, drive[k].scan.aperture);
    EXPECT_EQ(scan->sensorPose, drive[k].scan.sensor);
    ASSERT_EQ(scan->getScanSize(), drive[k].scan.ranges.size());
    for (std::size_t i = 0; i < scan->getScanSize(); ++i) {
      EXPECT_EQ(scan->getScanRange(i), drive[k].scan.ranges[i]);
      EXPECT_EQ(scan->getScanRangeValidity(i), drive[k].scan.isValid[i] != 0);
    }
  }
}

TEST(RawlogBytes, theSameScansGiveTheSameBytes) {
  EXPECT_EQ(rawlogBytes(test::sampleDrive(5)), rawlogBytes(test::sampleDrive(5)));
  EXPECT_EQ(readBack(rawlogBytes({})).size(), 0u);
}

TEST(Moved, movesAllPosesAndNoScan) {
  const std::vector<PlacedScan> before = test::sampleDrive(4);
  const std::vector<PlacedScan> after = moved(before, {10, 0, M_PI / 2});
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_NEAR(after[k].from.x(), 10 - before[k].from.y(), 1e-9);
    EXPECT_NEAR(after[k].from.y(), before[k].from.x(), 1e-9);
    EXPECT_EQ(after[k].scan.sensor, before[k].scan.sensor);
  }
}

}  // namespace
}  // namespace roomgraph
