#include "roomgraph/consensus/run_submaps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

/** A run with scans, all in a frame of its own. */
roomgraph::Run drivenRun() {
  const Grid grid = test::drawnBuilding(4, {});
  roomgraph::Run run;
  run.map = wallMap(grid, {});
  run.scans = scanWalls(test::drawnDrive(grid));
  return run;
}

roomgraph::Run scanlessRun() {
  roomgraph::Run run;
  run.map = wallMap(test::drawnBuilding(4, {3, -2, 0.5}), {});
  return run;
}

TEST(RunSubmaps, aScanIsOneAndIsLinkedToTheNext) {
  const roomgraph::Run run = drivenRun();
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

TEST(RunSubmaps, aScanHasDrawnTheWallsThatItMet) {
  const roomgraph::Run run = drivenRun();
  const RunSubmaps result = runSubmaps(run);
  ASSERT_EQ(result.drawnBy.size(), run.map.walls.size());
  std::vector<double> drawn(run.scans.size());
  for (std::size_t wall = 0; wall < result.drawnBy.size(); ++wall) {
    const auto& by = result.drawnBy[wall];
    EXPECT_TRUE(std::is_sorted(by.begin(), by.end()));
    EXPECT_EQ(std::adjacent_find(by.begin(), by.end()), by.end());
    for (const std::uint32_t k : by) {
      ++drawn[k];
      const auto& met = run.scans[k].walls;
      EXPECT_TRUE(std::any_of(met.begin(), met.end(),
                              [&](const WallPoint& point) {
                                return distance(point.place, run.map.walls[wall].place) < 0.15;
                              }))
          << "wall " << wall << " by " << k;
    }
  }
  for (std::size_t k = 0; k < drawn.size(); ++k)
    EXPECT_GT(drawn[k], 0.3 * double(run.scans[k].walls.size())) << k;  // many meet one wall
}

TEST(RunSubmaps, wallsThatTheScansDidNotMeetAreOfNone) {
  roomgraph::Run run = drivenRun();
  run.map = wallMap(test::drawnBuilding(4, {200, 0, 0}), {});
  for (const auto& by : runSubmaps(run).drawnBy) EXPECT_TRUE(by.empty());
}

TEST(RunSubmaps, withoutScansAPatchIsOne) {
  const roomgraph::Run run = scanlessRun();
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
  for (std::size_t wall = 0; wall < run.map.walls.size(); ++wall) {
    ASSERT_EQ(result.drawnBy[wall].size(), 1u);
    const auto& own = run.map.patches[result.drawnBy[wall][0]].own;
    EXPECT_NE(std::find(own.begin(), own.end(), wall), own.end());
  }
}

TEST(RunSubmaps, neighbouringPatchesAreLinkedOnce) {
  const roomgraph::Run run = scanlessRun();
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
  EXPECT_TRUE(result.drawnBy.empty());
}

}  // namespace
}  // namespace roomgraph
