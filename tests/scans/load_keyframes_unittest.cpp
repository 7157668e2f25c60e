#include "roomgraph/scans/load_keyframes.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <cmath>

#include "map_files.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/scans/load_scans.h"
#include "simplemap_entry.h"

namespace roomgraph {
namespace {

mrpt::obs::CObservation2DRangeScan& scanOf(mrpt::maps::CSimpleMap& map, std::size_t entry) {
  return dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(**test::entryOf(map, entry).sf->begin());
}

TEST(LoadKeyframes, givesEachScanWithWhatItsBeamsMet) {
  const test::TempDir dir;
  const auto frames =
      loadKeyframes(dir.write("map", test::gzipped(test::streamed(test::smallSimplemap()))), 30);
  ASSERT_EQ(frames.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(frames[i].pose.x, 0.5 * double(i) - 0.5);
    EXPECT_EQ(frames[i].pose.phi, 0);
    EXPECT_EQ(frames[i].ends.size(), 39u) << "one beam has no return";
    for (const Point end : frames[i].ends) {
      const Point at = frames[i].pose(end);  // on the walls of the square room
      EXPECT_NEAR(std::max(std::abs(at.x), std::abs(at.y)), 2, 1e-5);
    }
  }
}

TEST(LoadScans, givesTheScansOfTheKeyFrames) {
  const test::TempDir dir;
  const std::string file = dir.write("map", test::streamed(test::smallSimplemap()));
  const auto frames = loadKeyframes(file, LoadGridOptions());
  const auto scans = loadScans(file, LoadGridOptions());
  ASSERT_EQ(scans.size(), frames.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_EQ(scans[i].robot.x(), frames[i].pose.x);
    EXPECT_EQ(scans[i].robot.yaw(), frames[i].pose.phi);
    EXPECT_EQ(scans[i].scan.getScanSize(), 40u);
  }
  EXPECT_TRUE(loadScans(dir.write("grid", test::streamed(test::smallGrid())), {}).empty());
}

TEST(LoadKeyframes, areNumberedAsInTheFile) {
  const test::TempDir dir;
  auto map = test::smallSimplemap();
  dynamic_cast<mrpt::obs::CSensoryFrame&>(*test::entryOf(map, 1).sf).clear();
  const std::string file = dir.write("map", test::streamed(map));
  const auto frames = loadKeyframes(file, 30);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].number, 0u);
  EXPECT_EQ(frames[1].number, 2u);
  EXPECT_EQ(loadScans(file, LoadGridOptions())[1].keyFrame, 2u);
}

TEST(LoadKeyframes, leavesOutWhatIsTooFar) {
  const test::TempDir dir;
  const std::string file = dir.write("map", test::streamed(test::smallSimplemap()));
  for (const Keyframe& frame : loadKeyframes(file, 2.2)) {
    EXPECT_LT(frame.ends.size(), 39u);
    for (const Point end : frame.ends) EXPECT_LE(norm(end), 2.2);
  }
}

TEST(LoadKeyframes, tellsWhenAScanWasTakenWhereTheFileDoes) {
  const test::TempDir dir;
  auto map = test::smallSimplemap();
  scanOf(map, 1).timestamp = INVALID_TIMESTAMP;
  const auto frames = loadKeyframes(dir.write("map", test::streamed(map)), 30);
  ASSERT_EQ(frames.size(), 3u);
  ASSERT_TRUE(frames[0].time && frames[2].time);
  EXPECT_NEAR(*frames[0].time, 1.7e9 - 0.5, 1e-6);
  EXPECT_NEAR(*frames[2].time, 1.7e9 + 0.5, 1e-6);
  EXPECT_FALSE(frames[1].time);
}

TEST(LoadKeyframes, theSameRangesAreTheSameScanWhereverTheyWereTaken) {
  const test::TempDir dir;
  auto map = test::smallSimplemap();
  const auto before = loadKeyframes(dir.write("map", test::streamed(map)), 30);
  EXPECT_NE(before[0].scanId, before[1].scanId);
  dynamic_cast<mrpt::poses::CPose3DPDFGaussian&>(*test::entryOf(map, 0).pose).mean.x(7);
  scanOf(map, 1).setScanRange(3, 1);
  scanOf(map, 2).setScanRangeValidity(4, false);
  const auto after = loadKeyframes(dir.write("map", test::streamed(map)), 30);
  EXPECT_EQ(after[0].scanId, before[0].scanId);
  EXPECT_NE(after[1].scanId, before[1].scanId);
  EXPECT_NE(after[2].scanId, before[2].scanId);
}

TEST(LoadKeyframes, otherMapsHaveNone) {
  const test::TempDir dir;
  EXPECT_TRUE(loadKeyframes(dir.write("map", test::streamed(test::smallGrid())), 30).empty());
  EXPECT_TRUE(loadKeyframes(dir.write("map.yaml", "image: map.png\n"), 30).empty());
}

TEST(LoadKeyframes, aDamagedFileIsRefused) {
  const test::TempDir dir;
  const std::string bytes = test::streamed(test::smallSimplemap());
  EXPECT_THROW(loadKeyframes(dir.write("map", bytes.substr(0, bytes.size() / 2)), 30), DataError);
  EXPECT_THROW(loadKeyframes(dir.path("none"), 30), DataError);
}

}  // namespace
}  // namespace roomgraph
