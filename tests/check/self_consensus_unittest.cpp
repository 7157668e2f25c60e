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

/** A run that turns at one step, of which its scans say this, as it would lie. */
std::vector<Transform2D> agreedPoses(const std::vector<Keyframe>& frames, StepEvidence atTurn) {
  const Run run = test::runOf(frames);
  MendedSteps steps{test::posesOf(frames), {frames.size(), StepEvidence::agrees}};
  steps.evidence[20] = atTurn;
  return selfConsensus(run, localScans(run.scans), steps).poses;
}

TEST(SelfConsensus, wallsThatTurnAreAWingUnlessSomethingSpeaksAgainstTheStep) {
  const auto turned = test::broken(test::driveOnce(), 20, 0.14, {});
  const auto drawn = test::posesOf(turned), straight = test::posesOf(test::driveOnce());
  EXPECT_LT(test::stepsApart(agreedPoses(turned, StepEvidence::none), drawn), 0.02);
  EXPECT_LT(test::stepsApart(agreedPoses(turned, StepEvidence::lost), straight), 0.05);
}

TEST(SelfConsensus, whatWasSeenAgainAcrossATurnSpeaksAgainstIt) {
  const auto turned = test::broken(test::driveForthAndBack(), 20, 0.14, {});
  const auto straight = test::posesOf(test::driveForthAndBack());
  EXPECT_LT(test::stepsApart(agreedPoses(turned, StepEvidence::none), straight), 0.05);
}

/** A way of ten scans, a metre each, along which some were seen again `off` from where they lie. */
SelfConsensus seenAgain(const std::vector<std::pair<std::size_t, std::size_t>>& pairs, double off) {
  SelfConsensus consensus;
  for (int k = 0; k < 10; ++k) consensus.poses.push_back({double(k), 0, 0});
  for (const auto& [from, to] : pairs)
    consensus.revisits.push_back(
        matchEdge(NodeId(from), NodeId(to), {double(to) - double(from), off, 0}, 1));
  return consensus;
}

TEST(IsConfirmed, whereBothSidesOfABreakWereSeenTogether) {
  EXPECT_TRUE(isConfirmed(seenAgain({{1, 8}, {9, 2}}, 0.1), {5}));
  EXPECT_FALSE(isConfirmed(seenAgain({{1, 8}}, 0.1), {5})) << "one may be a look-alike";
  EXPECT_FALSE(isConfirmed(seenAgain({{4, 8}, {4, 9}}, 0.1), {5})) << "one scan, seen twice";
  EXPECT_FALSE(isConfirmed(seenAgain({{1, 4}, {2, 3}}, 0.1), {5})) << "both lie before it";
  EXPECT_FALSE(isConfirmed(seenAgain({{1, 8}, {2, 9}}, 1.0), {5})) << "they do not fit";
  EXPECT_TRUE(isConfirmed(seenAgain({{1, 8}, {2, 9}}, 0.1), {3, 8}));
  EXPECT_TRUE(isConfirmed(seenAgain({{1, 9}, {2, 9}}, 0.1), {9})) << "one scan is all behind it";
  EXPECT_FALSE(isConfirmed(seenAgain({{1, 7}, {2, 8}}, 0.1), {5, 9})) << "each break by itself";
}

TEST(IsConfirmed, notWhereMuchOfWhatWasSeenTwiceDoesNotFit) {
  SelfConsensus consensus = seenAgain({{1, 8}, {2, 8}, {3, 9}, {4, 9}}, 0);
  const SelfConsensus wrong = seenAgain({{0, 7}, {0, 6}}, 2);
  consensus.revisits.push_back(wrong.revisits[0]);
  EXPECT_TRUE(isConfirmed(consensus, {}));
  consensus.revisits.push_back(wrong.revisits[1]);
  EXPECT_FALSE(isConfirmed(consensus, {}));
}

TEST(IsConfirmed, notWhereNothingWasSeenTwice) { EXPECT_FALSE(isConfirmed(seenAgain({}, 0), {})); }

}  // namespace
}  // namespace roomgraph
