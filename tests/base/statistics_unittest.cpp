#include "roomgraph/base/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace roomgraph {
namespace {

TEST(LowerQuantile, isOneOfTheValues) {
  EXPECT_EQ(lowerQuantile({4, 1, 2}, 0), 1);
  EXPECT_EQ(lowerQuantile({4, 1, 2}, 0.5), 2);
  EXPECT_EQ(lowerQuantile({4, 1, 2}, 0.75), 2) << "where quantile is 3";
  EXPECT_EQ(lowerQuantile({4, 1, 2}, 1), 4);
  EXPECT_EQ(lowerQuantile({4, 1, 2, 8}, 0.5), 2) << "the lower of the two in the middle";
}

TEST(Quantile, liesBetweenTwoNeighboursOnTheStraightLine) {
  EXPECT_DOUBLE_EQ(quantile({4, 1, 2}, 0.75), 3);
  EXPECT_DOUBLE_EQ(quantile({30, 10, 20, 40, 50}, 0.9), 46);
  EXPECT_DOUBLE_EQ(quantile({2, 1}, 0.25), 1.25);
}

TEST(Quantile, ofNothingIsTheLeastAndOfAllTheLargest) {
  EXPECT_EQ(quantile({3, 1, 2}, 0), 1);
  EXPECT_EQ(quantile({3, 1, 2}, 1), 3);
  EXPECT_EQ(quantile({7}, 0.3), 7);
}

TEST(Median, isTheMiddleOrTheMeanOfTheTwoInTheMiddle) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
}

TEST(WeightedQuantile, isWhereMoreThanTheShareOfTheWeightIsReached) {
  const std::vector<WeightedValue> values{{3, 1}, {1, 7}, {2, 2}};
  EXPECT_EQ(weightedQuantile(values, 0), 1);
  EXPECT_EQ(weightedQuantile(values, 0.6), 1);
  EXPECT_EQ(weightedQuantile(values, 0.8), 2);
  EXPECT_EQ(weightedQuantile(values, 0.95), 3);
  EXPECT_EQ(weightedQuantile(values, 1), 3);
}

TEST(WeightedQuantile, isTheMeanOfTwoWhereExactlyTheShareIsReached) {
  EXPECT_EQ(weightedQuantile({{3, 1}, {1, 7}, {2, 2}}, 0.7), 1.5);
  // 0.1 + 0.1 + 0.1 is not 0.3 in binary; it is half of all the same.
  EXPECT_EQ(weightedQuantile({{1, 0.1}, {2, 0.1}, {3, 0.1}, {5, 0.3}}, 0.5), 4);
}

TEST(WeightedQuantile, whatHasNoWeightDoesNotCount) {
  EXPECT_EQ(weightedQuantile({{1, 0}, {2, 0.5}, {3, 0}}, 0.5), 2);
  EXPECT_EQ(weightedQuantile({{1, 1}, {2, 0}, {3, 1}}, 0.5), 2);
  EXPECT_FALSE(weightedQuantile({{1, 0}}, 0.5));
  EXPECT_FALSE(weightedQuantile({}, 0.5));
}

TEST(WeightedMedian, isTheMedianWhereAllWeightsAreTheSame) {
  EXPECT_EQ(weightedMedian({{3, 2}, {1, 2}, {2, 2}}), median({3, 1, 2}));
  EXPECT_EQ(weightedMedian({{4, 0.1}, {1, 0.1}, {3, 0.1}, {2, 0.1}}), median({4, 1, 3, 2}));
  EXPECT_EQ(weightedMedian({{3, 5}, {1, 1}, {2, 1}}), 3);
}

TEST(LowerWeightedMedian, isAlwaysOneOfTheValues) {
  EXPECT_EQ(lowerWeightedMedian({{4, 1}, {1, 1}}), 1);
  EXPECT_EQ(lowerWeightedMedian({{4, 2}, {1, 1}}), 4);
  EXPECT_FALSE(lowerWeightedMedian({{4, 0}}));
}

/** Some numbers at random, with ties. */
std::vector<double> anyValues(std::mt19937& random) {
  std::vector<double> values(1 + random() % 30);
  for (double& value : values) value = double(random() % 20) / 4;
  return values;
}

TEST(Quantile, isThatOfTheSortedValues) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<double> values = anyValues(random);
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double share = double(random() % 101) / 100, at = share * double(sorted.size() - 1);
    const std::size_t low = std::size_t(at), high = std::min(low + 1, sorted.size() - 1);
    EXPECT_NEAR(quantile(values, share),
                sorted[low] + (at - double(low)) * (sorted[high] - sorted[low]), 1e-12);
    EXPECT_EQ(lowerQuantile(values, share), sorted[low]) << share << " of " << sorted.size();
  }
}

TEST(WeightedQuantile, ofWholeWeightsIsThatOfRepeatedValues) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<WeightedValue> weighted;
    std::vector<double> repeated;
    for (const double value : anyValues(random)) {
      const int count = int(random() % 4);
      weighted.push_back({value, double(count)});
      repeated.insert(repeated.end(), std::size_t(count), value);
    }
    const auto found = weightedMedian(weighted);
    ASSERT_EQ(found.has_value(), !repeated.empty());
    if (found) {
      EXPECT_DOUBLE_EQ(*found, median(repeated)) << trial;
    }
    std::shuffle(weighted.begin(), weighted.end(), random);
    EXPECT_EQ(weightedMedian(weighted), found) << "in any order";
    const auto lower = lowerWeightedMedian(weighted);
    if (found) {
      EXPECT_LE(*lower, *found);
    }
  }
}

TEST(WeightedQuantile, onlyHowWeightsCompareCounts) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<WeightedValue> weighted, scaled;
    for (const double value : anyValues(random)) {
      weighted.push_back({value, 1 + double(random() % 5)});
      scaled.push_back({value, 1024 * weighted.back().weight});
    }
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0})
      EXPECT_EQ(weightedQuantile(weighted, share), weightedQuantile(scaled, share));
  }
}

}  // namespace
}  // namespace roomgraph
