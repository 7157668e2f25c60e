#include "scan_jitter.h"

#include <gtest/gtest.h>

#include "drawn_drive.h"
#include "sample_drives.h"

namespace roomgraph {
namespace {

double jitterOf(const std::vector<Keyframe>& frames) {
  const auto scans = scanWalls(frames);
  return scanJitter(scans, std::vector<Transform2D>(scans.size()));
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

TEST(ScanJitter, neitherADriftNorABreakIsOne) {
  EXPECT_LT(jitterOf(drifting(test::driveForthAndBack(), 0.01)), 0.07);
  EXPECT_LT(jitterOf(test::broken(test::driveOnce(), 20, 1, {2, 1})), 0.07);
}

TEST(ScanJitter, whatIsCarriedWhereItBelongsHasNone) {
  const auto frames = test::driveForthAndBack(), shakenFrames = test::shaken(frames, 0.2);
  const auto scans = scanWalls(shakenFrames);
  std::vector<Transform2D> carries;
  for (std::size_t k = 0; k < scans.size(); ++k)
    carries.push_back(frames[k].pose * shakenFrames[k].pose.inverse());
  EXPECT_LT(scanJitter(scans, carries), 0.05);
}

TEST(ScanJitter, tooFewScansTellNothing) {
  const auto& all = test::driveOnce();
  EXPECT_EQ(jitterOf({all.begin(), all.begin() + 5}), 0);
  EXPECT_EQ(scanJitter({}, {}), 0);
}

}  // namespace
}  // namespace roomgraph
