#include "roomgraph/mrpt_plugin/break_files.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>

#include <algorithm>
#include <cmath>

#include "mrpt_reads.h"
#include "sample_drive.h"

namespace roomgraph {
namespace {

MapBreak tearAt(std::optional<std::size_t> frame) {
  return {"torn", {4, 4}, 0.2, 1, frame, {}, TornPose{{5, 4, 0.2}, {4, 4, 0}}};
}

/** Two runs along a line; the second is torn at key frame 12 of 30. */
Comparison comparison() {
  Comparison result;
  result.runs.resize(2);
  result.runs[0].name = "good", result.runs[1].name = "torn";
  result.runs[1].pose = {1, 2, 0};
  result.breaks = {tearAt(12)};
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

TEST(BreakScene, showsTheTornPieceInBothPoses) {
  MrptScene scene = breakScene(comparison(), tearAt(12), runs());
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

TEST(BreakScene, namesStandAboveAllThatIsShown) {
  MrptScene scene = breakScene(comparison(), tearAt(12), runs());
  double top = -HUGE_VAL;
  for (const BreakPart& part : kBreakParts) {
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

TEST(BreakScene, isReadByMrpt) {
  const std::string bytes = breakSceneBytes(comparison(), tearAt(12), runs());
  EXPECT_EQ(bytes, breakSceneBytes(comparison(), tearAt(12), runs()));
  EXPECT_TRUE(test::sceneOf(bytes).getByName("untorn"));
}

TEST(BreakScene, withoutMapsItHoldsNothing) {
  MrptScene scene = breakScene(comparison(), tearAt(12), {});
  for (const char* name : {"good", "before", "drawn", "untorn"})
    EXPECT_FALSE(scene.getByName(name)) << name;
}

TEST(ScansAtBreak, thoseBehindItLieWhereTheyWouldWithoutIt) {
  const std::vector<PlacedScan> drive = test::sampleDrive(30);
  const MapBreak tear = tearAt(12);
  const auto drawn = scansAtBreak(tear, {}, drive, false),
             untorn = scansAtBreak(tear, {}, drive, true);
  ASSERT_EQ(drawn.size(), 20u);
  ASSERT_EQ(untorn.size(), 20u);
  const Transform2D motion = tear.torn->untorn * tear.torn->drawn.inverse();
  for (std::size_t k = 0; k < 20; ++k) {
    const auto& robot = drive[k + 2].from;
    EXPECT_NEAR(drawn[k].from.x(), robot.x(), 1e-9);
    const Point at{robot.x(), robot.y()}, expected = k < 10 ? at : motion(at);
    EXPECT_NEAR(untorn[k].from.x(), expected.x, 1e-9) << k;
    EXPECT_NEAR(untorn[k].from.y(), expected.y, 1e-9) << k;
  }
}

TEST(ScansAtBreak, lieInTheFrameOfTheSite) {
  const std::vector<PlacedScan> drive = test::sampleDrive(30);
  const auto scans = scansAtBreak(tearAt(12), {10, 20, 0}, drive, false);
  EXPECT_NEAR(scans[0].from.x(), drive[2].from.x() + 10, 1e-9);
  EXPECT_TRUE(scansAtBreak(tearAt({}), {}, drive, true).empty());
}

TEST(ScansAtDoubled, areThoseOfBothTimesAndTheSecondOnesFitWhereAsked) {
  const std::vector<PlacedScan> drive = test::sampleDrive(30);
  DoubledPlace place;
  place.one.first = 3, place.one.last = 5;
  place.other.first = 20, place.other.last = 21;
  place.mend = {0, 2, 0};
  const auto drawn = scansAtDoubled(place, drive, false);
  ASSERT_EQ(drawn.size(), 5u);
  EXPECT_EQ(drawn[2].keyFrame, 5u);
  EXPECT_EQ(drawn[3].keyFrame, 20u);
  const auto fits = scansAtDoubled(place, drive, true);
  EXPECT_NEAR(fits[2].from.y(), drawn[2].from.y(), 1e-9);
  EXPECT_NEAR(fits[4].from.y(), drawn[4].from.y() + 2, 1e-9);
}

}  // namespace
}  // namespace roomgraph
