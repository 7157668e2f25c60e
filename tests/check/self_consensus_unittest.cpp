#include "self_consensus.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

SelfConsensus agreed(const std::vector<Keyframe>& frames) {
  const Run run = test::runOf(frames);
  const auto scans = localScans(run.scans);
  return selfConsensus(run, scans, mendSteps(scans, test::posesOf(frames)));
}

TEST(SelfConsensus, aSoundRunAgreesWithItself) {
  const SelfConsensus consensus = agreed(test::driveForthAndBack());
  EXPECT_LT(consensus.error.error, 0.03);
  EXPECT_LT(test::stepsApart(consensus.poses, test::posesOf(test::driveForthAndBack())), 0.05);
}

TEST(SelfConsensus, aTornRunIsLaidAsItWasDriven) {
  const auto torn = test::broken(test::driveForthAndBack(), 50, 0.6, {1, 2});
  const SelfConsensus consensus = agreed(torn);
  EXPECT_GT(consensus.error.error, 1);
  EXPECT_LT(test::stepsApart(consensus.poses, test::posesOf(test::driveForthAndBack())), 0.2);
}

}  // namespace
}  // namespace roomgraph
