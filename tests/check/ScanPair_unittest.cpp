#include "roomgraph/check/ScanPair.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

std::vector<ScanWalls> way() {
  std::vector<ScanWalls> scans(40);
  for (std::size_t k = 0; k < scans.size(); ++k) scans[k].pose = {2 * double(k), 0, 0};
  return scans;
}

TEST(ScanPair, theEarlierScanIsOne) {
  EXPECT_EQ(scanPair(7, 3).one, 3u);
  EXPECT_EQ(scanPair(7, 3).other, 7u);
}

TEST(ScanPair, pairsLieBesideEachOtherWhereBothTheirScansDo) {
  const PathOfRun path(way());
  EXPECT_TRUE(path.areBeside({3, 20}, {6, 17}));
  EXPECT_FALSE(path.areBeside({3, 20}, {7, 20})) << "8 m of path";
  EXPECT_FALSE(path.areBeside({3, 20}, {3, 30}));
}

TEST(ScanPair, pairsAreOneGroupByThoseBetweenThem) {
  const PathOfRun path(way());
  const auto groups = path.grouped({{3, 30}, {9, 24}, {6, 27}, {20, 39}});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].size(), 3u);
  EXPECT_EQ(groups[1].front().one, 20u);
  EXPECT_TRUE(path.grouped({}).empty());
}

TEST(ScanPair, aStretchLeadsFromTheFirstKeyFrameToTheLast) {
  roomgraph::Run run;
  run.scans = way();
  for (std::size_t k = 0; k < run.scans.size(); ++k) run.scans[k].keyFrame = 100 + k;
  const DrawnStretch stretch = stretchOf(run, {{3, 30}, {9, 24}}, &ScanPair::other, 24);
  EXPECT_EQ(stretch.first, 124u);
  EXPECT_EQ(stretch.last, 130u);
  EXPECT_EQ(stretch.keyFrame, 124u);
  EXPECT_EQ(stretch.place.x, 48);
}

}  // namespace
}  // namespace roomgraph
