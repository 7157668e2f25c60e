#include <gtest/gtest.h>

#include "run_measures.h"

namespace roomgraph {
namespace {

/** A run with two walls and nothing else. */
roomgraph::Run between(Point a, Point b, double resolution) {
  roomgraph::Run run;
  run.map.frame.resolution = resolution;
  run.map.walls = {{a, {1, 0}}, {b, {1, 0}}};
  return run;
}

Site siteOf(const std::vector<const roomgraph::Run*>& runs, const std::vector<Transform2D>& poses) {
  Site site;
  site.runs = runs, site.poses = poses;
  return site;
}

TEST(SiteFrame, holdsTheWallsOfAllRunsWhereTheyLie) {
  const roomgraph::Run one = between({0, 0}, {4, 2}, 0.05), other = between({0, 0}, {1, 0}, 0.2);
  const GridFrame frame = siteFrame(siteOf({&one, &other}, {{}, {10, 5, 0}}));
  EXPECT_EQ(frame.resolution, 0.2) << "the coarsest";
  for (const Point p : {Point{0, 0}, Point{4, 2}, Point{10, 5}, Point{11, 5}})
    EXPECT_TRUE(frame.contains(frame.cellAt(p))) << p.x << " " << p.y;
  EXPECT_NEAR(frame.width * frame.resolution, 11, 0.3);
}

TEST(SiteFrame, aSiteWithoutWallsHasOneCell) {
  roomgraph::Run run;
  run.map.frame.resolution = 0.05;
  const GridFrame frame = siteFrame(siteOf({&run}, {{}}));
  EXPECT_EQ(frame.cellCount(), 1u);
  EXPECT_EQ(frame.resolution, 0.1);
}

TEST(SiteFrame, onlyWhatWasSeenFreeIsFree) {
  WallMap map;
  map.frame = {3, 1, 1, {}};
  map.states = {State::free, State::occupied, State::unknown};
  EXPECT_TRUE(isFreeIn(map, {0.5, 0.5}));
  EXPECT_FALSE(isFreeIn(map, {1.5, 0.5}));
  EXPECT_FALSE(isFreeIn(map, {2.5, 0.5}));
  EXPECT_FALSE(isFreeIn(map, {-0.5, 0.5})) << "outside";
}

}  // namespace
}  // namespace roomgraph
