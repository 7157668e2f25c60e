#include "map_measures.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "placed_graphs.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

using test::patchesOver;
using test::PlacedGraphs;

TEST(Brokenness, isTheNumberOfBreaksWhereThereAreScans) {
  PlacedGraphs graphs(std::vector<TopologyGraph>(3));
  graphs.runs[1].scans.resize(40);
  const MeasuredValue found = brokennessOf(graphs.site, graphs.pairs, graphs.trust, 1, 2);
  EXPECT_EQ(found.value, 2);
  EXPECT_EQ(found.support, 40);
  EXPECT_TRUE(found.hasEnoughOthers);
  EXPECT_EQ(found.worth, 30) << "scans, and not walls";
}

TEST(Brokenness, isWhatMostTrustSaysWhereThereAreNone) {
  PlacedGraphs graphs(std::vector<TopologyGraph>(4));
  const auto breakIn = [](FollowedWalls& followed) {
    const WallPatches patches = patchesOver({});
    for (FollowedPatch& f : followed.patches)
      if (patches[f.patch].middle.x > 10) f.pose = {0, 0.7, 0};
  };
  breakIn(graphs.pairs(0, 2).bInA), breakIn(graphs.pairs(1, 2).bInA);
  const MeasuredValue found = brokennessOf(graphs.site, graphs.pairs, graphs.trust, 2, 0);
  EXPECT_EQ(found.value, 1);
  EXPECT_EQ(found.low, 0);
  EXPECT_EQ(found.high, 1);
  EXPECT_EQ(brokennessOf(graphs.site, graphs.pairs, graphs.trust, 3, 0).value, 0);
}

TEST(Brokenness, oneRunAloneHasNone) {
  PlacedGraphs graphs(std::vector<TopologyGraph>(1));
  EXPECT_FALSE(brokennessOf(graphs.site, graphs.pairs, graphs.trust, 0, 0).value);
}

TEST(OwnMeasures, areOfTheMapAlone) {
  const Grid grid = test::drawnBuilding(4, {});
  roomgraph::Run run;
  run.map = wallMap(grid);
  for (const MeasuredValue& measured : {wallDoublingOf(run), wallSharpnessOf(run)}) {
    EXPECT_TRUE(measured.value);
    EXPECT_EQ(measured.support, double(run.map.walls.size()));
    EXPECT_FALSE(measured.low);
  }
  EXPECT_FALSE(scanDisagreementOf(run).value) << "no scans";
  std::vector<Keyframe> frames = test::drawnDrive(grid);
  const std::vector<Keyframe> back(frames.rbegin(), frames.rend());
  frames.insert(frames.end(), back.begin(), back.end());
  run.scans = scanWalls(frames);
  EXPECT_TRUE(scanDisagreementOf(run).value);
  EXPECT_GT(scanDisagreementOf(run).support, 10);
}

}  // namespace
}  // namespace roomgraph
