#include "roomgraph/base/median.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(Median, isTheMiddleOrTheMeanOfTheTwoInTheMiddle) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
}

TEST(WeightedMedian, isWhereHalfOfTheWeightIsReached) {
  EXPECT_EQ(weightedMedian({{3, 1}, {1, 1}, {2, 1}}), 2);
  EXPECT_EQ(weightedMedian({{3, 5}, {1, 1}, {2, 1}}), 3);
  EXPECT_EQ(weightedMedian({{2, 1}, {1, 1}}), 1) << "the lower of two";
}

TEST(WeightedMedian, whatHasNoWeightDoesNotCount) {
  EXPECT_EQ(weightedMedian({{1, 0}, {2, 0.5}, {3, 0}}), 2);
  EXPECT_FALSE(weightedMedian({{1, 0}}));
  EXPECT_FALSE(weightedMedian({}));
}

}  // namespace
}  // namespace roomgraph
