#include "roomgraph/scans/Recording.h"

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "drawn_cloud.h"
#include "map_files.h"
#include "newer_simplemap.h"
#include "roomgraph/map_files/read_recording.h"

namespace roomgraph {
namespace {

TEST(Recording, countsWhatARunHolds) {
  const TestFolder dir;
  const std::string bytes = test::asNewer(test::smallSimplemap(), {2, true, 8, true, true});
  const auto run = readRecording(dir.write("run", test::zstd(bytes, false)));
  ASSERT_TRUE(run);
  EXPECT_EQ(run->version, 2);
  EXPECT_EQ(run->compression, Compression::zstd);
  EXPECT_EQ(run->frames.size(), 6u);
  EXPECT_EQ(run->framesWithoutScans(), 3u);
  EXPECT_NEAR(run->pathLength(), 1, 1e-9);
  const auto times = run->times();
  ASSERT_TRUE(times);
  EXPECT_NEAR(times->second - times->first, 1, 1e-6);
  EXPECT_NEAR(times->first, 1.7e9 - 0.5, 1e-6);
  EXPECT_EQ(run->frames[0].time(), times->first);
  EXPECT_FALSE(run->frames[1].time());
  for (std::size_t k = 1; k < 6; ++k) EXPECT_EQ(run->frames[k].begin, run->frames[k - 1].end);
  ASSERT_EQ(run->sensors.size(), 2u);
  for (const auto& [sensor, count] : run->sensors) {
    EXPECT_EQ(count, 3u) << sensor.name();
    // A comment has the version that this MRPT gives it.
    EXPECT_EQ(sensor.label.empty() ? sensor.className : sensor.name(),
              sensor.label.empty() ? "CObservationComment" : "laser (CObservation2DRangeScan 8)");
  }
}

TEST(Recording, knowsCloudsEvenWhereTheirFilesAreMissing) {
  const TestFolder dir;
  const std::string outside = test::cloudBytes({}, "\3" + test::raw(std::uint32_t(5)) + "a.bin");
  const auto run = readRecording(dir.write("run", test::gzipped(test::oneObservation(outside))));
  ASSERT_TRUE(run);
  EXPECT_EQ(run->compression, Compression::gzip);
  EXPECT_EQ(run->sensors.count({"CObservationPointCloud", 0, "lidar"}), 1u);
  const auto times = run->times();
  ASSERT_TRUE(times);
  EXPECT_EQ(times->first, times->second);
}

}  // namespace
}  // namespace roomgraph
