#include "roomgraph/score/run_score.h"

#include <gtest/gtest.h>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

PairBends allBends(std::size_t n, double bend, double walls = 1000) {
  PairBends bends(n);
  for (const auto& [i, j] : bends.pairs()) bends(i, j) = {bend, 1, walls, false};
  return bends;
}

TEST(ScoreRuns, aLargerBendIsALowerScore) {
  double last = 101;
  for (const double bend : {0.05, 0.1, 0.3, 0.9, 2.0}) {
    const auto scores = scoreRuns(allBends(3, bend), {{}, {}, {}}, {}, {});
    EXPECT_LT(scores[0]->score, last);
    EXPECT_LE(scores[0]->low, scores[0]->score);
    EXPECT_GE(scores[0]->high, scores[0]->score);
    last = scores[0]->score;
  }
}

TEST(ScoreRuns, copiesOfOneMapCountAsOne) {
  PairBends bends = allBends(4, 0.3);
  const auto three = scoreRuns(allBends(3, 0.3), {{}, {}, {}}, {}, {});
  bends(0, 3) = {0, 1, 1000, true};
  const auto four = scoreRuns(bends, {{}, {}, {}, {}}, {}, {});
  EXPECT_NEAR(four[0]->score, three[0]->score, 1e-6);
  EXPECT_EQ(four[0]->score, four[3]->score);
}

TEST(ScoreRuns, aCopyIsNoFurtherWitness) {
  PairBends bends = allBends(3, 0.3);
  bends(0, 2) = {0, 1, 1000, true};
  for (const auto& score : scoreRuns(bends, {{}, {}, {}}, {}, {})) {
    EXPECT_EQ(score->others, 1u);
    EXPECT_EQ(score->bend, 0.3);
    EXPECT_FALSE(score->isMeaningful) << "these are two maps";
  }
}

TEST(ScoreRuns, thePieceOfASiteHasNoSayAndNoMeaning) {
  PairBends bends = allBends(4, 0.35);
  for (std::size_t i = 0; i < 3; ++i) bends(i, 3).share = 0.05;
  const auto scores = scoreRuns(bends, {{0.02, 0}, {0.02, 0}, {0.02, 0}, {0.0005, 0}}, {}, {});
  EXPECT_FALSE(scores[3]->isMeaningful);
  EXPECT_EQ(scores[3]->trust, 0);
  EXPECT_GT(scores[3]->bend, 0);
  const auto without = scoreRuns(allBends(3, 0.35), {{0.02, 0}, {0.02, 0}, {0.02, 0}}, {}, {});
  EXPECT_TRUE(scores[0]->isMeaningful);
  EXPECT_EQ(scores[0]->trust, 1);
  EXPECT_EQ(scores[0]->bend, without[0]->bend);
}

TEST(ScoreRuns, onlyCopiesScore100) {
  PairBends bends(2);
  bends(0, 1) = {0, 1, 1000, true};
  const auto scores = scoreRuns(bends, {{0.01, 0}, {0.01, 0}}, {}, {});
  for (const auto& score : scores) EXPECT_EQ(score->score, 100);
}

TEST(ScoreRuns, aReferenceIsTheTruth) {
  PairBends bends = allBends(3, 0.6);
  bends(0, 2).bend = 0.1;
  const auto scores = scoreRuns(bends, {{}, {}, {}}, 2, {});
  EXPECT_NEAR(scores[0]->mapError, 0.1, 0.03);
  EXPECT_NEAR(scores[1]->mapError, 0.6, 0.05);
  EXPECT_FALSE(scores[2]);
  EXPECT_TRUE(scores[0]->isMeaningful) << "one reference is enough";
  EXPECT_THROW(scoreRuns(bends, {{}, {}, {}}, 3, {}), UsageError);
  bends(0, 2) = {0, 1, 1000, true};
  EXPECT_EQ(scoreRuns(bends, {{}, {}, {}}, 2, {})[0]->score, 100) << "a copy of the reference";
}

TEST(ScoreRuns, twoRunsOrFewWallsAreNotEnough) {
  EXPECT_FALSE(scoreRuns(allBends(2, 0.1), {{}, {}}, {}, {})[0]->isMeaningful);
  EXPECT_TRUE(scoreRuns(allBends(3, 0.1), {{}, {}, {}}, {}, {})[0]->isMeaningful);
  EXPECT_FALSE(scoreRuns(allBends(3, 0.1, 20), {{}, {}, {}}, {}, {})[0]->isMeaningful);
}

TEST(ScoreRuns, theBestRunHasTheMostTrust) {
  PairBends bends = allBends(4, 0.1);
  for (std::size_t i = 0; i < 3; ++i) bends(i, 3).bend = 1;
  const auto scores = scoreRuns(bends, {{}, {}, {}, {}}, {}, {});
  EXPECT_NEAR(scores[0]->trust, 1, 1e-6);
  EXPECT_LT(scores[3]->trust, 0.05);
  EXPECT_NEAR(scores[0]->bend, 0.1, 0.02) << "the outlier weighs little";
}

TEST(ScoreRuns, theNoiseFloorWidensTheInterval) {
  const auto plain = scoreRuns(allBends(3, 0.3), {{}, {}, {}}, {}, {});
  const auto noisy = scoreRuns(allBends(3, 0.3), {{{}, 0.05}, {}, {}}, {}, {});
  EXPECT_NEAR(noisy[0]->errorHigh, plain[0]->errorHigh + 0.05, 1e-9);
  EXPECT_NEAR(noisy[0]->errorLow, plain[0]->errorLow - 0.05, 1e-9);
  EXPECT_EQ(noisy[0]->score, plain[0]->score);
  EXPECT_EQ(noisy[1]->errorHigh, plain[1]->errorHigh);
}

}  // namespace
}  // namespace roomgraph
