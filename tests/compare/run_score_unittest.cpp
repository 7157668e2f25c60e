#include "roomgraph/compare/run_score.h"

#include <gtest/gtest.h>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

PairBends allBends(std::size_t n, double bend, double walls = 1000) {
  PairBends bends(n);
  for (const auto& [i, j] : bends.pairs()) bends(i, j) = {bend, 1, walls, false};
  return bends;
}

std::vector<MapError> errorsOf(const std::vector<double>& values) {
  std::vector<MapError> errors;
  for (const double value : values) {
    errors.emplace_back();
    errors.back().error = value, errors.back().seen = 1;
    errors.back().low = value / 2, errors.back().high = 2 * value;
  }
  return errors;
}

RunScores scored(const PairBends& bends, const std::vector<MapError>& errors,
                 std::optional<std::size_t> reference, const CompareRunsOptions& options) {
  return scoreRuns(bends, DistinctMaps(bends), errors, reference, options);
}

TEST(ScoreRuns, aLargerErrorIsALowerScore) {
  const auto scores = scored(allBends(5, 0.3), errorsOf({0, 0.05, 0.1, 0.5, 2}), {}, {});
  double last = 100.1;
  for (const auto& score : scores) {
    EXPECT_LT(score->score, last);
    EXPECT_LE(score->low, score->score);
    EXPECT_GE(score->high, score->score);
    last = score->score;
  }
  EXPECT_EQ(scores[0]->score, 100);
  EXPECT_NEAR(scores[3]->score, 100 / M_E, 1e-9) << "half a metre";
}

TEST(ScoreRuns, aRunThatNobodyHasSeenHasNoScore) {
  std::vector<MapError> errors = errorsOf({0.1, 0.1, 0.1});
  errors[1].seen = 0;
  const auto scores = scored(allBends(3, 0.3), errors, {}, {});
  EXPECT_TRUE(scores[0]);
  EXPECT_FALSE(scores[1]);
}

TEST(ScoreRuns, aRunOfWhichOthersBearOutLessThanHalfHasNoMeaning) {
  std::vector<MapError> errors = errorsOf({0.1, 0.1, 0.1});
  errors[1].confirmed = 0.49, errors[1].contradicted = 0.2;
  errors[2].confirmed = 0.51, errors[2].jitter = 0.12, errors[2].scale = 1.01;
  errors[2].scaleSet = ScaleSet::larger;
  const auto scores = scored(allBends(3, 0.3), errors, {}, {});
  EXPECT_TRUE(scores[0]->isMeaningful);
  EXPECT_FALSE(scores[1]->isMeaningful);
  EXPECT_EQ(scores[1]->confirmed, 0.49);
  EXPECT_TRUE(scores[2]->isMeaningful);
  EXPECT_EQ(scores[2]->jitter, 0.12);
  EXPECT_EQ(scores[2]->scale, 1.01);
  EXPECT_TRUE(scores[2]->isScaleDisputed);
  EXPECT_EQ(scores[0]->confirmed, 1);
}

TEST(ScoreRuns, runsThatCannotBeToldDoNotShowThatAnotherOneErrs) {
  std::vector<MapError> errors = errorsOf({0.1, 0.1, 0.1});
  errors[0].contradicted = 0.1, errors[1].confirmed = errors[2].confirmed = 0.4;
  EXPECT_FALSE(scored(allBends(3, 0.3), errors, {}, {})[0]->isMeaningful);
  errors[2].confirmed = 1;
  EXPECT_TRUE(scored(allBends(3, 0.3), errors, {}, {})[0]->isMeaningful);
  errors[2].confirmed = 0.4, errors[0].contradicted = 0;
  EXPECT_TRUE(scored(allBends(3, 0.3), errors, {}, {})[0]->isMeaningful);
  // A copy of the run tells nothing more.
  errors = errorsOf({0.1, 0.1, 0.1, 0.1});
  errors[0].contradicted = errors[3].contradicted = 0.1;
  errors[1].confirmed = errors[2].confirmed = 0.4;
  PairBends bends = allBends(4, 0.3);
  bends(0, 3).areEdits = true;
  const auto scores = scored(bends, errors, {}, {});
  EXPECT_FALSE(scores[0]->isMeaningful || scores[3]->isMeaningful);
}

TEST(ScoreRuns, whatOthersContradictIsTrustedAsItsWorstCase) {
  std::vector<MapError> errors = errorsOf({0.1, 0.1, 0.1});
  errors[1].contradicted = 0.1, errors[1].high = 3;
  const auto scores = scored(allBends(3, 0.3), errors, {}, {});
  EXPECT_LT(scores[1]->trust, 1e-4);
  EXPECT_EQ(scores[2]->trust, 1);
}

TEST(ScoreRuns, aCopyIsNoFurtherWitness) {
  PairBends bends = allBends(3, 0.3);
  bends(0, 2) = {0, 1, 1000, true};
  for (const auto& score : scored(bends, errorsOf({0.2, 0.2, 0.2}), {}, {})) {
    EXPECT_EQ(score->others, 1u);
    EXPECT_FALSE(score->isMeaningful) << "these are two maps";
  }
}

TEST(ScoreRuns, editsOfOnePictureAreOneWitness) {
  PairBends bends = allBends(4, 0.3);
  for (const auto& [i, j] : {PairOfThings{0, 1}, {1, 2}}) bends(i, j).areEdits = true;
  const auto scores = scored(bends, errorsOf({0.2, 0.2, 0.2, 0.2}), {}, {});
  for (const auto& score : scores) {
    EXPECT_EQ(score->others, 1u);
    EXPECT_FALSE(score->isMeaningful) << "two drives";
  }
  EXPECT_GT(scores[0]->trust, 0);
  EXPECT_EQ(scores[1]->trust, 0) << "it has spoken already";
}

TEST(ScoreRuns, editsOfOnePictureAloneMeanNothing) {
  PairBends bends = allBends(3, 0.3);
  for (const auto& [i, j] : bends.pairs()) bends(i, j).areEdits = true;
  for (const auto& score : scored(bends, errorsOf({0.2, 0.2, 0.2}), {}, {})) {
    EXPECT_EQ(score->others, 2u) << "they are compared with each other";
    EXPECT_FALSE(score->isMeaningful);
  }
}

TEST(ScoreRuns, thePieceOfASiteHasNoSayAndNoMeaning) {
  PairBends bends = allBends(4, 0.35);
  for (std::size_t i = 0; i < 3; ++i) bends(i, 3).share = 0.05;
  const auto scores = scored(bends, errorsOf({0.2, 0.2, 0.2, 0}), {}, {});
  EXPECT_FALSE(scores[3]->isMeaningful);
  EXPECT_EQ(scores[3]->trust, 0);
  EXPECT_TRUE(scores[0]->isMeaningful);
  EXPECT_EQ(scores[0]->trust, 1);
}

TEST(ScoreRuns, aReferenceIsTheTruth) {
  const auto scores = scored(allBends(3, 0.6), errorsOf({0.1, 0.6, 0}), 2, {});
  EXPECT_FALSE(scores[2]);
  EXPECT_TRUE(scores[0]->isMeaningful) << "one reference is enough";
  EXPECT_EQ(scores[0]->others, 1u);
  EXPECT_EQ(trustOf(scores, 2), (Trust{0, 0, 1}));
  EXPECT_EQ(witnessesOf(scores, 2), (Trust{scores[0]->trust, scores[1]->trust, 1}));
  EXPECT_THROW(scored(allBends(3, 0.6), errorsOf({0, 0, 0}), 3, {}), UsageError);
  EXPECT_THROW(scored(allBends(3, 0.6), errorsOf({0, 0}), {}, {}), UsageError);
}

TEST(ScoreRuns, aReferenceThatIsBrokenItselfMeansNothing) {
  std::vector<MapError> errors = errorsOf({0.1, 0.6, 0});
  errors[0].givenUp = 0.36, errors[1].givenUp = 0.05;
  const auto scores = scored(allBends(3, 0.6), errors, 2, {});
  EXPECT_FALSE(scores[0]->isMeaningful);
  EXPECT_FALSE(scores[0]->fitsReference());
  EXPECT_TRUE(scores[1]->isMeaningful);
}

TEST(ScoreRuns, twoRunsOrFewWallsAreNotEnough) {
  const auto isMeaningful = [](std::size_t runs, double walls) {
    const std::vector<double> values(runs, 0.1);
    return scored(allBends(runs, 0.1, walls), errorsOf(values), {}, {})[0]->isMeaningful;
  };
  EXPECT_FALSE(isMeaningful(2, 1000));
  EXPECT_TRUE(isMeaningful(3, 1000));
  EXPECT_FALSE(isMeaningful(3, 20));
}

TEST(ScoreRuns, oneOtherAndAScanOrTwoAreNotEnough) {
  PairBends bends = allBends(3, 0.1);
  const auto shared = [&](double share) {
    for (const std::size_t run : {0u, 1u}) bends(run, 2).share = share;
    return scored(bends, errorsOf({0.1, 0.1, 0}), {}, {})[0]->isMeaningful;
  };
  EXPECT_TRUE(shared(0.25));
  EXPECT_FALSE(shared(0.02));
}

TEST(ScoreRuns, theBestRunHasTheMostTrust) {
  PairBends bends = allBends(4, 0.1);
  for (std::size_t i = 0; i < 3; ++i) bends(i, 3).bend = 1;
  const auto scores = scored(bends, errorsOf({0.07, 0.08, 0.08, 1}), {}, {});
  EXPECT_EQ(scores[0]->trust, 1);
  EXPECT_LT(scores[3]->trust, 0.05);
}

TEST(ScoreRuns, theOrderOfTheRunsChangesNothing) {
  PairBends bends(4), back(4);
  for (const auto& [i, j] : bends.pairs()) {
    bends(i, j) = {0.1 + 0.1 * double(i) + 0.03 * double(j), 0.5 + 0.1 * double(j), 500, false};
    back(3 - i, 3 - j) = bends(i, j);
  }
  const auto forth = scored(bends, errorsOf({0.1, 0.2, 0.3, 0.9}), {}, {});
  const auto other = scored(back, errorsOf({0.9, 0.3, 0.2, 0.1}), {}, {});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(forth[i]->score, other[3 - i]->score);
    EXPECT_NEAR(forth[i]->share, other[3 - i]->share, 1e-12);
    EXPECT_EQ(forth[i]->trust, other[3 - i]->trust);
    EXPECT_EQ(forth[i]->support, other[3 - i]->support);
  }
}

TEST(ScoreRuns, theShareIsTheMeanByTrust) {
  PairBends bends = allBends(3, 0);
  bends(0, 1) = {0.2, 0.5, 300, false}, bends(0, 2) = {0.8, 1, 700, false};
  const auto scores = scored(bends, errorsOf({0.1, 0.1, 0.3}), {}, {});
  const double one = scores[1]->trust * 0.5, two = scores[2]->trust * 1;
  EXPECT_NEAR(scores[0]->share, (one + two) / (scores[1]->trust + scores[2]->trust), 1e-12);
  EXPECT_EQ(scores[0]->support, 1000);
}

TEST(ScoreRuns, aRunWithoutAScoreHasNoSayInTheShares) {
  PairBends bends = allBends(3, 0.3);
  bends(0, 1).share = 0.2, bends(0, 2).share = 0.8;
  std::vector<MapError> errors = errorsOf({0.1, 0.1, 0.1});
  errors[1] = {};
  const auto scores = scored(bends, errors, {}, {});
  EXPECT_EQ(scores[0]->share, 0.8);
  EXPECT_EQ(scores[0]->trust, 1) << "of those that are trusted";
}

TEST(ScoreRuns, whereAllAreSmallTheyAreTrustedAllTheSame) {
  PairBends bends = allBends(3, 0.2);
  for (const auto& [i, j] : bends.pairs()) bends(i, j).share = 0.05;
  for (const auto& score : scored(bends, errorsOf({0.1, 0.1, 0.1}), {}, {})) {
    EXPECT_EQ(score->trust, 1);
    EXPECT_FALSE(score->isMeaningful);
  }
}

TEST(ScoreRuns, ofNoRunsThereAreNone) {
  EXPECT_TRUE(scored(PairBends(), {}, {}, {}).empty());
  EXPECT_TRUE(trustOf({}, {}).empty());
}

TEST(TrustOf, aRunWithoutAScoreHasNone) {
  std::vector<MapError> errors = errorsOf({0.1, 0.1, 0.1});
  errors[2].seen = 0;
  EXPECT_EQ(trustOf(scored(allBends(3, 0.1), errors, {}, {}), {}), (Trust{1, 1, 0}));
}

}  // namespace
}  // namespace roomgraph
