#include <gtest/gtest.h>

#include "drawn_drive.h"
#include "extend_errors.h"
#include "roomgraph/align/LocalScan.h"
#include "sample_drives.h"

namespace roomgraph {
namespace {

double jitterOf(const std::vector<Keyframe>& frames) {
  const auto scans = scanWalls(frames);
  return scanJitter(scans, drawnPoses(scans)).drawn;
}

std::vector<Keyframe> drifting(std::vector<Keyframe> frames, double turn) {
  for (std::size_t i = 1; i < frames.size(); ++i) frames = test::broken(frames, i, turn, {});
  return frames;
}

TEST(ScanJitter, aSoundRunHasHardlyAny) { EXPECT_LT(jitterOf(test::driveOnce()), 0.05); }

TEST(ScanJitter, scansThatAreOffOnTheirOwnTellByHowMuch) {
  const double little = jitterOf(test::shaken(test::driveForthAndBack(), 0.1));
  const double much = jitterOf(test::shaken(test::driveForthAndBack(), 0.2));
  EXPECT_GT(little, 0.1);
  EXPECT_LT(little, 0.2);
  EXPECT_GT(much, 1.5 * little);
}

TEST(ScanJitter, scansThatOnlySeeTheNextTellToo) {
  const std::vector<Keyframe> all = test::shaken(test::driveForthAndBack(), 0.1);
  std::vector<Keyframe> few;
  for (std::size_t k = 0; k < all.size(); k += 2) few.push_back(all[k]);
  EXPECT_NEAR(jitterOf(few), jitterOf(all), 0.05);
}

TEST(ScanJitter, neitherADriftNorABreakIsOne) {
  EXPECT_LT(jitterOf(drifting(test::driveForthAndBack(), 0.01)), 0.07);
  EXPECT_LT(jitterOf(test::broken(test::driveOnce(), 20, 1, {2, 1})), 0.07);
}

TEST(ScanJitter, whatLiesWhereItBelongsHasNoneLeft) {
  const auto& frames = test::driveForthAndBack();
  const auto scans = scanWalls(test::shaken(frames, 0.2));
  std::vector<Transform2D> poses;
  for (const Keyframe& frame : frames) poses.push_back(frame.pose);
  const ScanJitter mended = scanJitter(scans, poses), drawn = scanJitter(scans, drawnPoses(scans));
  EXPECT_LT(mended.left, 0.05);
  EXPECT_EQ(mended.drawn, drawn.drawn);
  EXPECT_EQ(drawn.left, drawn.drawn);
}

TEST(ScanJitter, tooFewScansTellNothing) {
  const auto& all = test::driveOnce();
  EXPECT_EQ(jitterOf({all.begin(), all.begin() + 5}), 0);
  EXPECT_EQ(scanJitter({}, {}).drawn, 0);
}

}  // namespace
}  // namespace roomgraph
