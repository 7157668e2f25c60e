#include "roomgraph/base/statistics.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace roomgraph
