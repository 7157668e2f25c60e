#include "roomgraph/mrpt_plugin/fault_files.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>

#include <algorithm>
#include <cmath>

#include "mrpt_reads.h"
#include "sample_drive.h"

namespace roomgraph {
namespace {

/** A run named "torn" whose key frames from 12 on are to be moved. */
Fault faultAt12() {
  Fault fault;
  fault.run = "torn", fault.place = {4, 4}, fault.keyFrame = 12;
  fault.earlier = {2, 11}, fault.later = {12, 21};
  fault.mend = TornPose{{5, 4, 0.2}, {4, 4, 0}}.mend();
  return fault;
}

/** Two runs along a line; the second is torn at key frame 12 of 30. */
Comparison comparison() {
  Comparison result;
  result.runs.resize(2);
  result.runs[0].name = "good", result.runs[1].name = "torn";
  result.runs[1].pose = {1, 2, 0};
  return result;
}

std::vector<Run> runs() {
  std::vector<Run> both(2);
  both[0].name = "torn", both[1].name = "good";
  for (std::size_t k = 0; k < 30; ++k) {
    both[0].scans.emplace_back();
    both[0].scans.back().keyFrame = k;
    both[0].scans.back().pose = {0.5 * double(k), 0, 0};
    both[0].scans.back().walls = {{{0.5 * double(k), 1}, {0, -1}}};
  }
  both[1].map.walls = {{{0, 0}, {0, 1}}, {{1, 0}, {0, 1}}};
  return both;
}

std::shared_ptr<viz::CPointCloud> cloudOf(MrptScene& scene, const char* name) {
  const auto set = std::dynamic_pointer_cast<viz::CSetOfObjects>(scene.getByName(name));
  return set ? set->getByClass<viz::CPointCloud>() : nullptr;
}

TEST(FaultScene, showsTheTornPieceInBothPoses) {
  MrptScene scene = faultScene(comparison(), faultAt12(), runs());
  EXPECT_TRUE(scene.getByName("run good"));
  const auto before = cloudOf(scene, "before"), drawn = cloudOf(scene, "drawn"),
             untorn = cloudOf(scene, "untorn");
  ASSERT_TRUE(before && drawn && untorn);
  ASSERT_EQ(before->size(), 10u);
  ASSERT_EQ(drawn->size(), 10u);
  ASSERT_EQ(untorn->size(), 10u);
  EXPECT_NEAR(double(before->getPoint3Df(0).x), 1 + 0.5 * 2, 1e-5);
  EXPECT_NEAR(double(drawn->getPoint3Df(0).x), 1 + 0.5 * 12, 1e-5);
  EXPECT_NEAR(double(drawn->getPoint3Df(0).y), 3, 1e-5);
  // From (7, 3): 2 to the right of and 1 below the drawn pose, turned back by 0.2.
  EXPECT_NEAR(double(untorn->getPoint3Df(0).x), 4 + 2 * std::cos(0.2) - std::sin(0.2), 1e-5);
  EXPECT_NEAR(double(untorn->getPoint3Df(0).y), 4 - std::cos(0.2) - 2 * std::sin(0.2), 1e-5);
}

TEST(FaultScene, namesStandAboveAllThatIsShown) {
  MrptScene scene = faultScene(comparison(), faultAt12(), runs());
  double top = -HUGE_VAL;
  for (const FaultPart& part : kFaultParts) {
    const auto cloud = cloudOf(scene, part.name);
    ASSERT_TRUE(cloud) << part.name;
    for (std::size_t i = 0; i < cloud->size(); ++i)
      top = std::max(top, double(cloud->getPoint3Df(i).y));
  }
  const auto text = scene.getByClass<viz::CText3D>();
  ASSERT_TRUE(text);
  EXPECT_EQ(text->getString(), "before");
  EXPECT_GT(text->getPose().y, top);
}

TEST(FaultScene, isReadByMrpt) {
  const std::string bytes = faultSceneBytes(comparison(), faultAt12(), runs());
  EXPECT_EQ(bytes, faultSceneBytes(comparison(), faultAt12(), runs()));
  EXPECT_TRUE(test::sceneOf(bytes).getByName("untorn"));
}

TEST(FaultScene, withoutMapsItHoldsNothing) {
  MrptScene scene = faultScene(comparison(), faultAt12(), {});
  for (const char* name : {"good", "before", "drawn", "untorn"})
    EXPECT_FALSE(scene.getByName(name)) << name;
}

TEST(FaultScene, ofWhatNobodyCanMendNothingIsShownMended) {
  Fault fault = faultAt12();
  fault.mend.reset();
  MrptScene scene = faultScene(comparison(), fault, runs());
  EXPECT_TRUE(scene.getByName("drawn"));
  EXPECT_FALSE(scene.getByName("untorn"));
}

TEST(ScansAtFault, theLaterOnesLieWhereTheyFit) {
  const std::vector<PlacedScan> drive = test::sampleDrive(30);
  const auto drawn = scansAtFault(faultAt12(), {}, drive, false),
             untorn = scansAtFault(faultAt12(), {}, drive, true);
  ASSERT_EQ(drawn.size(), 20u);
  ASSERT_EQ(untorn.size(), 20u);
  for (std::size_t k = 0; k < 20; ++k) {
    const auto& robot = drive[k + 2].from;
    EXPECT_NEAR(drawn[k].from.x(), robot.x(), 1e-9);
    const Point at{robot.x(), robot.y()}, expected = k < 10 ? at : (*faultAt12().mend)(at);
    EXPECT_NEAR(untorn[k].from.x(), expected.x, 1e-9) << k;
    EXPECT_NEAR(untorn[k].from.y(), expected.y, 1e-9) << k;
  }
}

TEST(ScansAtFault, lieInTheFrameOfTheSite) {
  const std::vector<PlacedScan> drive = test::sampleDrive(30);
  const auto scans = scansAtFault(faultAt12(), {10, 20, 0}, drive, false);
  EXPECT_NEAR(scans[0].from.x(), drive[2].from.x() + 10, 1e-9);
  Fault ofGrid = faultAt12();
  ofGrid.earlier = ofGrid.later = {};
  EXPECT_TRUE(scansAtFault(ofGrid, {}, drive, true).empty());
}

}  // namespace
}  // namespace roomgraph
