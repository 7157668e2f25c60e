#include "roomgraph/scans/make_keyframes.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <cmath>

#include "TestFolder.h"
#include "map_files.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/load_grid.h"
#include "simplemap_entry.h"

namespace roomgraph {
namespace {

mrpt::obs::CObservation2DRangeScan& scanOf(mrpt::maps::CSimpleMap& map, std::size_t entry) {
  return dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(**test::entryOf(map, entry).sf->begin());
}

std::vector<Keyframe> keyframesOf(const std::string& file, double maxRange = 30) {
  LoadGridOptions options;
  options.maxDistanceInsertion = maxRange;
  return loadMap(file, options).keyframes;
}

TEST(MakeKeyframes, givesEachScanWithWhatItsBeamsMet) {
  const TestFolder dir;
  const auto frames =
      keyframesOf(dir.write("map", test::gzipped(test::streamed(test::smallSimplemap()))));
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

TEST(MakeKeyframes, areNumberedAsInTheFile) {
  const TestFolder dir;
  auto map = test::smallSimplemap();
  dynamic_cast<mrpt::obs::CSensoryFrame&>(*test::entryOf(map, 1).sf).clear();
  const auto frames = keyframesOf(dir.write("map", test::streamed(map)));
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].number, 0u);
  EXPECT_EQ(frames[1].number, 2u);
}

TEST(MakeKeyframes, leavesOutWhatIsTooFar) {
  const TestFolder dir;
  const std::string file = dir.write("map", test::streamed(test::smallSimplemap()));
  for (const Keyframe& frame : keyframesOf(file, 2.2)) {
    EXPECT_LT(frame.ends.size(), 39u);
    for (const Point end : frame.ends) EXPECT_LE(norm(end), 2.2);
  }
}

TEST(MakeKeyframes, tellsWhenAScanWasTakenWhereTheFileDoes) {
  const TestFolder dir;
  auto map = test::smallSimplemap();
  scanOf(map, 1).timestamp = INVALID_TIMESTAMP;
  const auto frames = keyframesOf(dir.write("map", test::streamed(map)));
  ASSERT_EQ(frames.size(), 3u);
  ASSERT_TRUE(frames[0].time && frames[2].time);
  EXPECT_NEAR(*frames[0].time, 1.7e9 - 0.5, 1e-6);
  EXPECT_NEAR(*frames[2].time, 1.7e9 + 0.5, 1e-6);
  EXPECT_FALSE(frames[1].time);
}

TEST(MakeKeyframes, theSameRangesAreTheSameScanWhereverTheyWereTaken) {
  const TestFolder dir;
  auto map = test::smallSimplemap();
  const auto before = keyframesOf(dir.write("map", test::streamed(map)));
  EXPECT_NE(before[0].scanId, before[1].scanId);
  dynamic_cast<mrpt::poses::CPose3DPDFGaussian&>(*test::entryOf(map, 0).pose).mean.x(7);
  scanOf(map, 1).setScanRange(3, 1);
  scanOf(map, 2).setScanRangeValidity(4, false);
  const auto after = keyframesOf(dir.write("map", test::streamed(map)));
  EXPECT_EQ(after[0].scanId, before[0].scanId);
  EXPECT_NE(after[1].scanId, before[1].scanId);
  EXPECT_NE(after[2].scanId, before[2].scanId);
}

TEST(MakeKeyframes, otherMapsHaveNone) {
  const TestFolder dir;
  EXPECT_TRUE(keyframesOf(dir.write("map", test::streamed(test::smallGrid()))).empty());
}

TEST(MakeKeyframes, aDamagedFileIsRefused) {
  const TestFolder dir;
  const std::string bytes = test::streamed(test::smallSimplemap());
  EXPECT_THROW(keyframesOf(dir.write("map", bytes.substr(0, bytes.size() / 2))), DataError);
  EXPECT_THROW(keyframesOf(dir / "none"), DataError);
}

}  // namespace
}  // namespace roomgraph
