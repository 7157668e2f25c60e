#include "roomgraph/breaks/site_breaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "drawn_building.h"
#include "drawn_pose_graph.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/consensus/find_consensus.h"
#include "sample_drives.h"

namespace roomgraph {
namespace {

using test::roundTheBlock;
using test::Way;

/** Runs with scans, and their consensus. */
struct DrivenSite {
  std::vector<roomgraph::Run> runs;
  Site site;
  Consensus consensus;

  explicit DrivenSite(const std::vector<Way>& drawn, const std::vector<Way>& truth) {
    for (const Way& way : drawn) {
      runs.emplace_back();
      runs.back().name = "run " + std::to_string(runs.size());
      for (const Transform2D& pose : way) {
        runs.back().scans.emplace_back();
        runs.back().scans.back().keyFrame = 2 * (runs.back().scans.size() - 1);  // every other one
        runs.back().scans.back().pose = pose;
        runs.back().scans.back().time = 1e9 + 0.5 * double(runs.back().scans.size());
      }
      consensus.siteRuns.add(runs.size() - 1);
      consensus.graphRuns.emplace_back(runs.size() - 1);
    }
    for (const roomgraph::Run& run : runs) site.runs.push_back(&run);
    site.poses.assign(runs.size(), {});
    consensus.graph = test::matchedPoseGraph(drawn, truth);
    consensus.poses = findConsensus(consensus.graph).best;
    consensus.errors = mapErrors(consensus.graph, consensus.poses);
  }
  DrivenSite(const DrivenSite&) = delete;

  std::vector<std::vector<MapBreak>> breaks() const {
    return siteBreaks(site, MapPairs(runs.size()), consensus, Trust(runs.size(), 1), {}, oneByOne);
  }
};

TEST(SiteBreaks, aTornDriveShowsWhereAndByHowMuch) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  for (const double turn : {0.2, -M_PI / 2, M_PI}) {
    const Way drawn = test::torn(truth[1], 33, turn, {3, -4});
    const DrivenSite site({truth[0], drawn, truth[2]}, truth);
    const auto breaks = site.breaks();
    ASSERT_EQ(breaks[1].size(), 1u) << turn;
    const MapBreak& found = breaks[1][0];
    EXPECT_EQ(found.run, "run 2");
    EXPECT_EQ(found.keyFrame, 66u);
    EXPECT_EQ(found.time, site.runs[1].scans[33].time);
    EXPECT_NEAR(wrappedAngle(found.rotation - turn), 0, 0.01) << turn;
    EXPECT_NEAR(found.shift, 5, 0.1) << turn;
    EXPECT_LT(distance(found.place, truth[1][33].shift()), 0.1) << "as the map before it has it";
    ASSERT_TRUE(found.torn);
    EXPECT_LT(distance(found.torn->drawn.shift(), drawn[33].shift()), 1e-9);
    EXPECT_NEAR(wrappedAngle(found.torn->drawn.phi - drawn[33].phi), 0, 1e-9);
    EXPECT_LT(distance(found.torn->untorn.shift(), truth[1][33].shift()), 0.1);
    EXPECT_NEAR(wrappedAngle(found.torn->untorn.phi - truth[1][33].phi), 0, 0.01);
    EXPECT_TRUE(breaks[0].empty());
    EXPECT_TRUE(breaks[2].empty());
  }
}

TEST(SiteBreaks, thePlaceIsInTheFrameOfTheSite) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  const Transform2D there{20, -9, 1.2};
  DrivenSite site({truth[0], test::moved(test::torn(truth[1], 33, 0.5, {}), there), truth[2]},
                  truth);
  site.site.poses[1] = there.inverse();
  const auto breaks = site.breaks();
  ASSERT_EQ(breaks[1].size(), 1u);
  EXPECT_LT(distance(breaks[1][0].place, truth[1][33].shift()), 0.1);
  EXPECT_LT(distance(breaks[1][0].torn->untorn.shift(), truth[1][33].shift()), 0.1);
  const Transform2D drawn = there.inverse() * site.runs[1].scans[33].pose;
  EXPECT_LT(distance(breaks[1][0].torn->drawn.shift(), drawn.shift()), 1e-9);
  EXPECT_NEAR(breaks[1][0].shift, 0, 0.1);
}

TEST(SiteBreaks, aRunThatNobodyElseHasSeenIsNotTornByItself) {
  const std::vector<Way> truth{roundTheBlock()};
  const DrivenSite site({test::torn(truth[0], 33, 0.5, {3, -4})}, truth);
  EXPECT_TRUE(site.breaks()[0].empty());
}

TEST(SiteBreaks, eachTearOfARunIsOne) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  const Way once = test::torn(truth[2], 15, 1, {0, 3});
  const DrivenSite site({truth[0], truth[1], test::torn(once, 45, -0.5, {2, 0})}, truth);
  const auto breaks = site.breaks()[2];
  ASSERT_EQ(breaks.size(), 2u);
  EXPECT_EQ(breaks[0].keyFrame, 30u);
  EXPECT_EQ(breaks[1].keyFrame, 90u);
  EXPECT_NEAR(breaks[1].shift, 2, 0.1);
}

TEST(SiteBreaks, aStepThatTheScansHoldAsItWasDrawnIsNone) {
  const std::vector<Keyframe> frames = test::driveForthAndBack();
  const Way drawn = test::posesOf(frames);
  DrivenSite site({drawn, drawn, drawn}, {drawn, test::torn(drawn, 18, 0.4, {}), drawn});
  EXPECT_EQ(site.breaks()[1].size(), 1u) << "of scans that show nothing";
  site.runs[1].scans = test::runOf(frames).scans;
  EXPECT_TRUE(site.breaks()[1].empty());
}

TEST(SiteBreaks, aSlightOneIsBorneOutByTheScansOnBothSides) {
  const std::vector<Keyframe> frames = test::driveForthAndBack();
  const Way truth = test::posesOf(frames), torn = test::torn(truth, 18, 0.06, {});
  for (const bool isTorn : {true, false}) {
    DrivenSite site({truth, isTorn ? torn : truth, truth}, {truth, isTorn ? truth : torn, truth});
    EXPECT_TRUE(site.breaks()[1].empty()) << "of scans that show nothing";
    site.runs[1].scans = test::runOf(test::broken(frames, 18, isTorn ? 0.06 : 0, {})).scans;
    EXPECT_EQ(site.breaks()[1].size(), isTorn ? 1u : 0u);
  }
}

TEST(SiteBreaks, soundAndSlowlyDriftingRunsHaveNone) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  const DrivenSite site({truth[0], test::drifting(truth[1], 0.003), truth[2]}, truth);
  EXPECT_GT(site.consensus.errorOf(1).error, 0.3) << "it does drift";
  for (const auto& breaks : site.breaks()) EXPECT_TRUE(breaks.empty());
}

/** Maps of one building without scans, each followed in each other. */
std::vector<std::vector<MapBreak>> breaksOf(
    const std::vector<Grid>& grids, const Trust& trust,
    const std::function<void(Site&, MapPairs&)>& change = [](Site&, MapPairs&) {}) {
  std::vector<roomgraph::Run> runs;
  for (const Grid& grid : grids) {
    runs.emplace_back();
    runs.back().map = wallMap(grid);
  }
  Site site;
  for (const roomgraph::Run& run : runs) site.runs.push_back(&run);
  site.poses.assign(runs.size(), {});
  MapPairs pairs(runs.size());
  for (const auto& [i, j] : pairs.pairs()) follow(pairs(i, j), runs[i].map, runs[j].map, {{}});
  change(site, pairs);
  return siteBreaks(site, pairs, {}, trust, {}, oneByOne);
}

TEST(SiteBreaks, aMapWithoutScansBreaksWhereTheTrustedOnesSaySo) {
  const Grid sound = test::drawnBuilding(1, {}), broken = test::bent(sound, 0.08);
  const Point middle = sound.frame.center({sound.frame.width / 2, sound.frame.height / 2});
  const auto breaks = breaksOf({broken, sound, sound}, {0.1, 1, 1});
  ASSERT_EQ(breaks[0].size(), 1u);
  EXPECT_NEAR(std::abs(breaks[0][0].rotation), 0.08, 0.02) << "its halves are alike";
  EXPECT_NEAR(breaks[0][0].place.x, middle.x, 2.5);
  EXPECT_FALSE(breaks[0][0].keyFrame);
  EXPECT_FALSE(breaks[0][0].time);
  EXPECT_FALSE(breaks[0][0].torn);
  EXPECT_TRUE(breaks[1].empty());
  EXPECT_TRUE(breaks[2].empty());
}

TEST(SiteBreaks, aMapWithoutScansBreaksWhereItIsDrawn) {
  const Grid sound = test::drawnBuilding(1, {}), broken = test::bent(sound, 0.12);
  const Point middle = sound.frame.center({sound.frame.width / 2, sound.frame.height / 2});
  const Transform2D pose{30, -4, 2};
  const auto breaks = breaksOf({broken, sound, sound}, {0.1, 1, 1},
                               [&](Site& site, MapPairs&) { site.poses[0] = pose; });
  ASSERT_EQ(breaks[0].size(), 1u);
  EXPECT_LT(distance(breaks[0][0].place, pose(middle)), 1.5);
}

/** Forgets what was found right of the middle of the first map in another one. */
void forgetFarSide(Site& site, FollowedWalls& followed) {
  const WallMap& map = site.runs[0]->map;
  auto& found = followed.patches;
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const FollowedPatch& f) {
                               return map.patches[f.patch].middle.x > map.middle().x;
                             }),
              found.end());
}

TEST(SiteBreaks, aMapThatLacksAPieceSaysNothingOfTheBreak) {
  const Grid sound = test::drawnBuilding(1, {}), broken = test::bent(sound, 0.12);
  const auto forget = [](Site& site, MapPairs& pairs) { forgetFarSide(site, pairs(0, 1).aInB); };
  EXPECT_EQ(breaksOf({broken, sound, sound}, {0.1, 1, 1}, forget)[0].size(), 1u);
  const auto deny = [](Site&, MapPairs& pairs) {
    for (FollowedPatch& f : pairs(0, 1).aInB.patches) f.pose = {};
  };
  EXPECT_TRUE(breaksOf({broken, sound, sound}, {0.1, 1, 1}, deny)[0].empty());
}

TEST(SiteBreaks, ofTwoMapsTheOneThatIsTrustedLessIsBroken) {
  const Grid sound = test::drawnBuilding(1, {}), broken = test::bent(sound, 0.08);
  const auto breaks = breaksOf({sound, broken}, {1, 0.1});
  EXPECT_TRUE(breaks[0].empty());
  EXPECT_EQ(breaks[1].size(), 1u);
}

TEST(SiteBreaks, worseMapsDoNotLayTheirBreaksOnABetterOne) {
  const Grid sound = test::drawnBuilding(1, {}), broken = test::bent(sound, 0.08);
  EXPECT_TRUE(breaksOf({sound, broken, broken}, {1, 0.01, 0.01})[0].empty());
  EXPECT_EQ(breaksOf({sound, broken, broken}, {1, 0.9, 0.9})[0].size(), 1u) << "who errs, then";
}

TEST(SiteBreaks, aRunAloneHasNone) {
  const Way way = roundTheBlock();
  for (const auto& breaks : DrivenSite({test::torn(way, 30, 1, {3, 4})}, {way}).breaks())
    EXPECT_TRUE(breaks.empty());
  EXPECT_TRUE(breaksOf({}, {}).empty());
}

}  // namespace
}  // namespace roomgraph
