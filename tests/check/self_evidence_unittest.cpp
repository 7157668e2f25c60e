#include "self_evidence.h"

#include <gtest/gtest.h>

#include <map>

#include "sample_drives.h"

namespace roomgraph {
namespace {

std::map<std::string, Evidence> evidenceOf(const std::vector<Keyframe>& frames) {
  const Run run = test::runOf(frames);
  const auto scans = localScans(run.scans);
  const MendedSteps mended = mendSteps(scans, drawnPoses(run.scans));
  std::map<std::string, Evidence> rows;
  const SelfConsensus consensus = selfConsensus(run, scans, mended);
  const auto drawn = beamsThroughWalls(scans, drawnPoses(run.scans));
  for (const Evidence& row :
       selfEvidence(run, mended, consensus, drawn, beamsThroughWalls(scans, consensus.poses)))
    rows[row.name] = row;
  return rows;
}

TEST(SelfEvidence, speaksForASoundRun) {
  auto rows = evidenceOf(test::driveForthAndBack());
  EXPECT_EQ(rows["steps_contradicted"].drawn, 0);
  EXPECT_GT(rows["steps_contradicted"].support, 10);
  EXPECT_LT(rows["revisits_apart"].drawn, 0.1);
  EXPECT_LT(rows["beams_through_walls"].drawn, 0.02);
}

TEST(SelfEvidence, speaksAgainstATornOneAsDrawnAndForItAsItAgrees) {
  auto rows = evidenceOf(test::broken(test::driveForthAndBack(), 50, 0.4, {1, 2}));
  EXPECT_GT(rows["steps_contradicted"].drawn, 0);
  EXPECT_GT(rows["revisits_apart"].drawn, 1);
  EXPECT_LT(rows["revisits_apart"].agreed, 0.2);
  EXPECT_GT(rows["beams_through_walls"].drawn, 0.1);
  EXPECT_LT(rows["beams_through_walls"].agreed, 0.05);
}

TEST(SelfEvidence, ofWhatWasDrivenOnceSomeRowsHaveNoFigure) {
  const auto& once = test::driveOnce();
  auto rows = evidenceOf({once.begin(), once.begin() + 20});
  EXPECT_TRUE(rows["steps_contradicted"].drawn);
  EXPECT_FALSE(rows["revisits_apart"].drawn);
  EXPECT_FALSE(rows["beams_through_walls"].drawn);
}

TEST(SelfEvidence, ofAMapTheFiguresAreThoseOfAComparison) {
  roomgraph::Run run;
  run.map.axisDeviation = M_PI / 90, run.map.wallDoubling = 0.1;
  const std::vector<Evidence> rows = mapEvidence(run);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].name, "axis_deviation");
  EXPECT_NEAR(*rows[0].drawn, 2, 1e-9);
  EXPECT_EQ(rows[1].drawn, 0.1);
  EXPECT_FALSE(rows[2].drawn);
}

}  // namespace
}  // namespace roomgraph
