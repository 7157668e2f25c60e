#include "map_measures.h"

#include <gtest/gtest.h>

#include <algorithm>

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
  EXPECT_FALSE(scanDisagreement(run.scans).value) << "no scans";
  std::vector<Keyframe> frames = test::drawnDrive(grid);
  const std::vector<Keyframe> back(frames.rbegin(), frames.rend());
  frames.insert(frames.end(), back.begin(), back.end());
  run.scans = scanWalls(frames);
  EXPECT_TRUE(scanDisagreement(run.scans).value);
  EXPECT_GT(scanDisagreement(run.scans).support, 10);
}

/** A drive to the end of a corridor and back again; the way back may be shifted as a whole. */
std::vector<ScanWalls> thereAndBack(Point shift) {
  static const std::vector<Keyframe> there =
      test::drawnDrive(test::drawnBuilding(4, {0.3, 0.2, 0.1}));
  std::vector<Keyframe> frames = there;
  for (std::size_t i = there.size(); i-- > 0;) {
    Keyframe frame = there[i];
    frame.pose.x += shift.x, frame.pose.y += shift.y;
    frames.push_back(frame);
  }
  return scanWalls(frames);
}

TEST(ScanDisagreement, aTrueDriveHasLittle) {
  const MeasuredValue found = scanDisagreement(thereAndBack({}));
  EXPECT_LT(found.value.value(), 0.06);
  EXPECT_GT(found.support, 30);
}

TEST(ScanDisagreement, growsWithTheShiftOfTheSecondVisit) {
  const double small = scanDisagreement(thereAndBack({0.1, 0.15})).value.value();
  const double large = scanDisagreement(thereAndBack({0.3, 0.4})).value.value();
  EXPECT_GT(small, 0.06);
  EXPECT_GT(large, small + 0.05);
  EXPECT_LE(large, 0.5);
}

TEST(ScanDisagreement, theSameSceneAMomentLaterTellsNothing) {
  std::vector<ScanWalls> scans = thereAndBack({});
  scans.resize(9);  // 4 m of path
  const MeasuredValue found = scanDisagreement(scans);
  EXPECT_FALSE(found.value);
  EXPECT_EQ(found.support, 0);
}

TEST(ScanDisagreement, withoutScansThereIsNone) {
  EXPECT_FALSE(scanDisagreement({}).value);
  EXPECT_FALSE(scanDisagreement(std::vector<ScanWalls>(3)).value);
}

TEST(ScanDisagreement, theFrameOfTheRunChangesLittle) {
  std::vector<ScanWalls> scans = thereAndBack({0.1, 0.15});
  const double here = scanDisagreement(scans).value.value();
  const Transform2D motion{50, -20, 2};
  for (ScanWalls& scan : scans) {
    scan.pose = motion * scan.pose;
    for (WallPoint& wall : scan.walls)
      wall.place = motion(wall.place), wall.normal = turned(wall.normal, motion.phi);
  }
  const MeasuredValue there = scanDisagreement(scans);
  EXPECT_NEAR(there.value.value(), here, 1e-6);
}

TEST(ScanDisagreement, drivenBackwardsIsTheSameDrive) {
  std::vector<ScanWalls> scans = thereAndBack({0.1, 0.15});
  const MeasuredValue forth = scanDisagreement(scans);
  std::reverse(scans.begin(), scans.end());
  const MeasuredValue back = scanDisagreement(scans);
  EXPECT_NEAR(back.value.value(), forth.value.value(), 1e-9);
  EXPECT_EQ(back.support, forth.support);
}

TEST(ScanDisagreement, wallsThatFaceAwayAreNotTheSame) {
  std::vector<ScanWalls> scans = thereAndBack({});
  const std::size_t half = scans.size() / 2;
  for (std::size_t k = half; k < scans.size(); ++k)
    for (WallPoint& wall : scans[k].walls) wall.normal = -1.0 * wall.normal;
  const MeasuredValue found = scanDisagreement(scans);
  EXPECT_LT(found.support, scanDisagreement(thereAndBack({})).support);
}

}  // namespace
}  // namespace roomgraph
