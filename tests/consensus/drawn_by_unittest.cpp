#include "roomgraph/consensus/drawn_by.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sample_runs.h"

namespace roomgraph {
namespace {

// The nodes of a run that is not the first of its graph.
constexpr std::size_t kFirstNode = 100;

DrawnBy drawnBy(const roomgraph::Run& run) {
  const std::size_t nodes = run.scans.empty() ? run.map.patches.size() : run.scans.size();
  return drawnBy(run, {kFirstNode, kFirstNode + nodes}, run.map);
}

/** By their places in the run. */
std::vector<std::size_t> drawersOf(const DrawnBy& drawn, std::size_t wall) {
  std::vector<std::size_t> places;
  for (std::uint32_t k = drawn.firsts[wall]; k < drawn.firsts[wall + 1]; ++k)
    places.push_back(drawn.nodes[k].index() - kFirstNode);
  return places;
}

TEST(DrawnBy, aScanHasDrawnTheWallsThatItMet) {
  const roomgraph::Run run = test::drivenRun();
  const DrawnBy result = drawnBy(run);
  ASSERT_EQ(result.firsts.size(), run.map.walls.size() + 1);
  ASSERT_EQ(result.firsts.back(), result.nodes.size());
  std::vector<double> drawn(run.scans.size());
  for (std::size_t wall = 0; wall < run.map.walls.size(); ++wall) {
    const auto by = drawersOf(result, wall);
    EXPECT_TRUE(std::is_sorted(by.begin(), by.end()));
    EXPECT_EQ(std::adjacent_find(by.begin(), by.end()), by.end());
    for (const std::size_t k : by) {
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

TEST(DrawnBy, wallsThatTheScansDidNotMeetAreOfNone) {
  roomgraph::Run run = test::drivenRun();
  run.map = wallMap(test::drawnBuilding(4, {200, 0, 0}));
  EXPECT_TRUE(drawnBy(run).nodes.empty());
}

TEST(DrawnBy, withoutScansAWallIsOfItsPatch) {
  const roomgraph::Run run = test::scanlessRun();
  const DrawnBy result = drawnBy(run);
  for (std::size_t wall = 0; wall < run.map.walls.size(); ++wall) {
    const auto by = drawersOf(result, wall);
    ASSERT_EQ(by.size(), 1u);
    const auto& own = run.map.patches[by[0]].own;
    EXPECT_NE(std::find(own.begin(), own.end(), wall), own.end());
  }
}

TEST(DrawnBy, ofNothingIsNone) { EXPECT_TRUE(drawnBy(roomgraph::Run()).nodes.empty()); }

}  // namespace
}  // namespace roomgraph
