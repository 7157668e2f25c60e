#include "roomgraph/consensus/run_submaps.h"

#include <gtest/gtest.h>

#include "sample_runs.h"

namespace roomgraph {
namespace {

TEST(RunSubmaps, aScanIsOneAndIsLinkedToTheNext) {
  const roomgraph::Run run = test::drivenRun();
  const RunSubmaps result = runSubmaps(run);
  EXPECT_TRUE(result.areScans);
  ASSERT_EQ(result.submaps.size(), run.scans.size());
  ASSERT_EQ(result.links.size(), run.scans.size() - 1);
  for (std::uint32_t k = 0; k < run.scans.size(); ++k) {
    EXPECT_EQ(result.submaps[k].pose.shift(), run.scans[k].at());
    EXPECT_EQ(result.submaps[k].points.count, run.scans[k].ends.count);
    EXPECT_EQ(result.submaps[k].points.xx, run.scans[k].ends.xx);
    EXPECT_EQ(result.submaps[k].axes.has_value(), run.scans[k].axes.has_value());
    if (k == 0) continue;
    EXPECT_EQ(result.links[k - 1].from, k - 1);
    EXPECT_EQ(result.links[k - 1].to, k);
  }
}

TEST(RunSubmaps, withoutScansAPatchIsOne) {
  const roomgraph::Run run = test::scanlessRun();
  const RunSubmaps result = runSubmaps(run);
  EXPECT_FALSE(result.areScans);
  ASSERT_EQ(result.submaps.size(), run.map.patches.size());
  for (std::size_t k = 0; k < result.submaps.size(); ++k) {
    const Submap& submap = result.submaps[k];
    EXPECT_EQ(submap.pose.shift(), run.map.patches[k].middle);
    EXPECT_EQ(submap.points.count, double(run.map.patches[k].own.size()));
    EXPECT_NEAR(submap.points.x, 0, 1e-6) << "its middle is the mean of its walls";
    EXPECT_FALSE(submap.axes);
  }
}

TEST(RunSubmaps, neighbouringPatchesAreLinkedOnce) {
  const roomgraph::Run run = test::scanlessRun();
  std::size_t sides = 0;
  for (const WallPatch& patch : run.map.patches) sides += patch.neighbours.size();
  const RunSubmaps result = runSubmaps(run);
  EXPECT_EQ(2 * result.links.size(), sides);
  for (const SubmapLink& link : result.links) EXPECT_LT(link.from, link.to);
}

TEST(RunSubmaps, ofNothingThereAreNone) {
  const RunSubmaps result = runSubmaps({});
  EXPECT_TRUE(result.submaps.empty());
  EXPECT_TRUE(result.links.empty());
}

}  // namespace
}  // namespace roomgraph
