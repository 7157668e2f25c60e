#include "roomgraph/consensus/estimate_map_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "RandomNumbers.h"
#include "drawn_bends.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {
namespace {

using test::bendsOf;

using Deviations = std::vector<std::optional<double>>;

Deviations untold(std::size_t n) { return Deviations(n); }

TEST(EstimateMapErrors, findsTheErrorsBehindTheBends) {
  const std::vector<double> truth{0.05, 0.1, 0.3, 0.7, 1.5};
  const auto found = estimateMapErrors(bendsOf(truth), untold(5), {});
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ASSERT_TRUE(found[i]);
    EXPECT_NEAR(found[i]->error, truth[i], 0.1 * truth[i]) << i;
    EXPECT_LT(found[i]->low, truth[i]);
    EXPECT_GT(found[i]->high, truth[i]);
  }
}

TEST(EstimateMapErrors, oneOutlierMovesLittle) {
  const auto with = [](double far) {
    return estimateMapErrors(bendsOf({0.05, 0.1, 0.1, 0.2, far}), untold(5), {});
  };
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(with(0.2)[i]->error, with(4)[i]->error, 0.015);
}

TEST(EstimateMapErrors, oneWrongPairMovesLittle) {
  PairBends bends = bendsOf({0.1, 0.1, 0.2, 0.2, 0.3, 0.3});
  const auto before = estimateMapErrors(bends, untold(6), {});
  bends(0, 1).bend = 5;
  const auto after = estimateMapErrors(bends, untold(6), {});
  for (std::size_t i = 2; i < 6; ++i) EXPECT_NEAR(after[i]->error, before[i]->error, 0.03);
  EXPECT_LT(after[0]->error, 0.25);
}

TEST(EstimateMapErrors, twoMapsAreToldApartByTheirDeviations) {
  const PairBends bends = bendsOf({0.3, 0.3});
  const auto alike = estimateMapErrors(bends, untold(2), {});
  EXPECT_NEAR(alike[0]->error, alike[1]->error, 1e-6);
  const auto told = estimateMapErrors(bends, {0.01, 0.05}, {});
  EXPECT_LT(told[0]->error, 0.5 * told[1]->error);
  EXPECT_NEAR(std::hypot(told[0]->error, told[1]->error), bends(0, 1).bend, 0.1);
}

TEST(EstimateMapErrors, aTornMapBetweenTwoSoundOnesIsTheBadOneHoweverStraight) {
  for (const double torn : {0.7, 4.0, 30.0}) {
    const PairBends bends = bendsOf({torn, 0.1, 0.2});
    const auto found = estimateMapErrors(bends, {0.009, 0.01, 0.011}, {});
    EXPECT_NEAR(found[0]->error, torn, 0.15 * torn);
    EXPECT_LT(found[1]->error, 0.5) << torn;
    EXPECT_LT(found[2]->error, 0.5) << torn;
  }
}

TEST(EstimateMapErrors, onlyTheRatioOfTheDeviationsCounts) {
  const PairBends bends = bendsOf({0.1, 0.4, 0.2});
  const auto tenfold = [](double deviation) {  // over the noise
    return 10 * (deviation + fitted::kDeviationNoise) - fitted::kDeviationNoise;
  };
  const auto one = estimateMapErrors(bends, {0.01, 0.03, 0.02}, {});
  const auto other = estimateMapErrors(bends, {tenfold(0.01), tenfold(0.03), tenfold(0.02)}, {});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(one[i]->error, other[i]->error, 1e-4);
}

TEST(EstimateMapErrors, thatASmallPieceIsStraightSaysLittleAndThatItIsBentSaysAll) {
  const auto errorOf = [](double share, double deviation) {
    PairBends bends = bendsOf({0.2, 0.2, 0.2, 0.2});
    for (std::size_t i = 0; i < 3; ++i) bends(i, 3).share = share;
    return estimateMapErrors(bends, {0.02, 0.02, 0.02, deviation}, {})[3]->error;
  };
  EXPECT_GT(errorOf(0.3, 0.005), 1.3 * errorOf(1, 0.005));
  EXPECT_LT(errorOf(0.3, 0.005), errorOf(0.3, 0.02));
  EXPECT_GT(errorOf(0.05, 0.2), 3 * errorOf(0.05, 0.02));
}

TEST(EstimateMapErrors, theOrderOfTheMapsChangesNothing) {
  const std::vector<double> truth{0.05, 0.4, 0.2, 0.9};
  const auto forth = estimateMapErrors(bendsOf(truth), {0.01, 0.03, 0.02, 0.06}, {});
  const auto back = estimateMapErrors(bendsOf({0.9, 0.2, 0.4, 0.05}), {0.06, 0.02, 0.03, 0.01}, {});
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(forth[i]->error, back[3 - i]->error, 1e-5);
}

TEST(EstimateMapErrors, moreMapsMakeItSurer) {
  const auto widthWith = [](std::size_t n) {
    const auto found = estimateMapErrors(bendsOf(std::vector<double>(n, 0.3)), untold(n), {});
    return found[0]->high - found[0]->low;
  };
  EXPECT_LT(widthWith(5), widthWith(3));
  EXPECT_LT(widthWith(10), widthWith(5));
}

TEST(EstimateMapErrors, againstTheTruthTheBendIsTheError) {
  PairBends bends = bendsOf({0.5, 0.5, 0});
  bends(0, 2).bend = 0.1, bends(1, 2).bend = 0.7;
  const auto found = estimateMapErrors(bends, untold(3), 2);
  EXPECT_FALSE(found[2]);
  EXPECT_NEAR(found[0]->error, 0.1, 0.05);
  EXPECT_NEAR(found[1]->error, 0.7, 0.15);
}

TEST(EstimateMapErrors, whereTheTruthHasLittleOfAMapTheOthersTell) {
  PairBends bends = bendsOf({0.1, 1.0, 0});
  bends(1, 2) = {0.1, 0.1, 100, false};  // only the part that fits was found
  const auto found = estimateMapErrors(bends, untold(3), 2);
  EXPECT_GT(found[1]->error, 0.6);
}

TEST(EstimateMapErrors, aMapWithoutAPairHasNone) {
  PairBends bends = bendsOf({0.1, 0.2, 0.3});
  for (std::size_t i = 0; i < 2; ++i) bends(i, 2) = {};
  const auto found = estimateMapErrors(bends, untold(3), {});
  EXPECT_TRUE(found[0] && found[1]);
  EXPECT_FALSE(found[2]);
  EXPECT_TRUE(estimateMapErrors(PairBends(), {}, {}).empty());
  EXPECT_FALSE(estimateMapErrors(bendsOf({0.1}), untold(1), {})[0]);
}

/** What the bends cost where the maps err so, as the header has it. */
double costOf(const PairBends& bends, const std::vector<double>& errors) {
  double cost = 0;
  for (const auto& [i, j] : bends.pairs()) {
    const PairBend& pair = bends(i, j);
    const double r = std::log((pair.bend + fitted::kBendNoise) /
                              (std::hypot(errors[i], errors[j]) + fitted::kBendNoise));
    const double width = r > 0 ? fitted::kBendAbove : fitted::kBendBelow,
                 s = 1 + r * r / width / width;
    cost += pair.share * width * width * (r > 0 ? std::log(s) / 2 : std::sqrt(s) - 1);
  }
  return cost;
}

TEST(EstimateMapErrors, noErrorCanChangeAloneAndExplainMore) {
  test::RandomNumbers random(1);
  for (int trial = 0; trial < 10; ++trial) {
    PairBends bends(6);
    for (const auto& [i, j] : bends.pairs())
      bends(i, j) = {random.between(0.1, 1), random.between(0.3, 1), 1000, false};
    std::vector<double> errors;
    for (const auto& found : estimateMapErrors(bends, untold(6), {}))
      errors.push_back(found->error + fitted::kLeastError);
    const double best = costOf(bends, errors);
    for (std::size_t i = 0; i < 6; ++i)
      for (const double factor : {0.98, 1.02}) {
        std::vector<double> other = errors;
        other[i] = std::max(fitted::kLeastError, factor * other[i]);
        EXPECT_GE(costOf(bends, other), best - 1e-4 * best) << trial << ' ' << i;
      }
  }
}

TEST(EstimateMapErrors, theIntervalHoldsTheError) {
  test::RandomNumbers random(2);
  PairBends bends(5);
  for (const auto& [i, j] : bends.pairs())
    bends(i, j) = {random.between(0, 2), random.between(0.1, 1), 1000, false};
  for (const auto& found : estimateMapErrors(bends, untold(5), {})) {
    EXPECT_GE(found->error, 0);
    EXPECT_LE(found->low, found->error);
    EXPECT_GE(found->high, found->error);
  }
}

TEST(EstimateMapErrors, noErrorIsBelowNothingOrBeyondAllMeasure) {
  const auto none = estimateMapErrors(bendsOf({0, 0, 0}), untold(3), {});
  for (const auto& found : none) EXPECT_NEAR(found->error, 0, 0.02);
  const auto huge = estimateMapErrors(bendsOf({1e6, 1e6, 1e6}), untold(3), {});
  for (const auto& found : huge) EXPECT_LE(found->error, kMaxBend + 1e-9);
}

}  // namespace
}  // namespace roomgraph
