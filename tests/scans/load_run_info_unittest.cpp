#include "roomgraph/scans/load_run_info.h"

#include <gtest/gtest.h>

#include "drawn_cloud.h"
#include "map_files.h"
#include "newer_simplemap.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

TEST(LoadRunInfo, countsWhatARunHolds) {
  const test::TempDir dir;
  const std::string bytes = test::asNewer(test::smallSimplemap(), {2, true, 8, true, true});
  const auto info = loadRunInfo(dir.write("run", test::zstd(bytes, false)));
  ASSERT_TRUE(info);
  EXPECT_EQ(info->version, 2);
  EXPECT_EQ(info->compression, Compression::zstd);
  EXPECT_EQ(info->keyframes, 6u);
  EXPECT_EQ(info->keyframesWithoutScans, 3u);
  EXPECT_NEAR(info->pathLength, 1, 1e-9);
  ASSERT_TRUE(info->start && info->end);
  EXPECT_NEAR(*info->end - *info->start, 1, 1e-6);
  EXPECT_NEAR(*info->start, 1.7e9 - 0.5, 1e-6);
  EXPECT_EQ(info->sensors, (std::map<std::string, std::size_t>{
                               {"CObservationComment 0", 3},
                               {"laser (CObservation2DRangeScan 8)", 3},
                           }));
}

TEST(LoadRunInfo, knowsCloudsEvenWhereTheirFilesAreMissing) {
  const test::TempDir dir;
  const std::string outside = test::cloudBytes({}, "\3" + test::raw(std::uint32_t(5)) + "a.bin");
  const auto info = loadRunInfo(dir.write("run", test::gzipped(test::oneObservation(outside))));
  ASSERT_TRUE(info);
  EXPECT_EQ(info->compression, Compression::gzip);
  EXPECT_EQ(info->sensors.at("lidar (CObservationPointCloud 0)"), 1u);
  EXPECT_EQ(info->start, info->end);
}

TEST(LoadRunInfo, otherMapsAreNoRuns) {
  const test::TempDir dir;
  EXPECT_FALSE(loadRunInfo(dir.write("map", test::streamed(test::smallGrid()))));
  EXPECT_FALSE(loadRunInfo(dir.write("map", "P2 1 1 255 7\n")));
  const std::string bytes = test::streamed(test::smallSimplemap());
  EXPECT_THROW(loadRunInfo(dir.write("map", bytes.substr(0, 900))), DataError);
}

}  // namespace
}  // namespace roomgraph
