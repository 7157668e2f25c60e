#include <gtest/gtest.h>

#include "drawn_pose_graph.h"
#include "extend_errors.h"

namespace roomgraph {
namespace {

using test::scaled;

/** Runs of these scales; the consensus has them at 1. */
Consensus consensusOf(const std::vector<double>& scales) {
  std::vector<test::Way> drawn, truth;
  for (const double scale : scales) {
    drawn.push_back(scaled(test::roundTheBlock(), scale));
    truth.push_back(test::roundTheBlock());
  }
  Consensus consensus;
  consensus.graph = test::drawnPoseGraph(drawn);
  for (const RunId run : consensus.graph.runs.ids())
    consensus.graph.setStretch(run, 1 / scales[run.index()]);
  consensus.poses = test::posesOf(truth);
  consensus.errors = mapErrors(consensus.graph, consensus.poses);
  for (MapError& one : consensus.errors) one.seen = 1, one.low = 0, one.high = 0.02;
  tellScales(consensus);
  return consensus;
}

std::vector<ScaleSet> setsOf(const Consensus& consensus) {
  std::vector<ScaleSet> sets;
  for (const MapError& error : consensus.errors) sets.push_back(error.scaleSet);
  return sets;
}

using Sets = std::vector<ScaleSet>;
constexpr ScaleSet kOne = ScaleSet::one, kSmall = ScaleSet::smaller, kLarge = ScaleSet::larger;

TEST(RunScales, areToldAgainstTheConsensus) {
  const Consensus consensus = consensusOf({1.03, 1, 0.98});
  EXPECT_NEAR(consensus.errors[RunId(0)].scale, 1.03, 1e-6);
  EXPECT_NEAR(consensus.errors[RunId(2)].scale, 0.98, 1e-6);
}

TEST(RunScales, aMajorityOfAnotherScaleIsNotRightForBeingOne) {
  const Consensus consensus = consensusOf({1.005, 1.006, 0.986, 1.0055, 0.985});
  EXPECT_EQ(setsOf(consensus), (Sets{kLarge, kLarge, kSmall, kLarge, kSmall}));
  const double reach = 7;  // of a block of 20 m by 10 m, at least
  for (const MapError& error : consensus.errors) EXPECT_GT(error.high, 0.018 * reach);
}

TEST(RunScales, ofThreeRunsEitherSideMayBeRight) {
  EXPECT_EQ(setsOf(consensusOf({1.01, 1.01, 0.99})), (Sets{kLarge, kLarge, kSmall}));
}

TEST(RunScales, aRunThatIsOffByItsScaleAloneMayBeExact) {
  Consensus consensus = consensusOf({1.01, 1.01, 0.99});
  for (MapError& error : consensus.errors) {
    error.error += 0.02;  // what remains without its scale
    error.low = 0.9 * error.error, error.high = 1.1 * error.error;
  }
  tellScales(consensus);
  for (const MapError& error : consensus.errors) EXPECT_LT(error.low, 0.015);
}

TEST(RunScales, ofTwoThatAreConfirmedNothingIsTold) {
  Consensus consensus = consensusOf({1, 1, 1});
  consensus.graph.setStretch(RunId(1), 1 / 1.04);
  consensus.errors[RunId(2)].confirmed = 0.2;
  tellScales(consensus);
  EXPECT_EQ(setsOf(consensus), Sets(3, kOne));
  EXPECT_EQ(consensus.errors[RunId(1)].scale, 1);
}

TEST(RunScales, oneRunOfManyIsOutvoted) {
  const Consensus consensus = consensusOf({1, 1.0005, 0.9995, 1.02});
  EXPECT_EQ(setsOf(consensus), Sets(4, kOne));
  EXPECT_EQ(consensus.errors[RunId(3)].high, 0.02);
}

TEST(RunScales, smallOrSpreadDifferencesAreNoSets) {
  EXPECT_EQ(setsOf(consensusOf({1, 1.001, 1.004, 1.0045})), Sets(4, kOne));
  EXPECT_EQ(setsOf(consensusOf({0.98, 0.99, 1, 1.01})), Sets(4, kOne));
  EXPECT_EQ(setsOf(consensusOf({1, 1.02})), Sets(2, kOne)) << "two runs";
  EXPECT_EQ(setsOf(consensusOf({})), Sets{});
}

}  // namespace
}  // namespace roomgraph
