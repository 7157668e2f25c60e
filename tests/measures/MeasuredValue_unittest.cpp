#include "MeasuredValue.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** The mean of what the others say, by their support. */
MeasuredValue meanOf(const std::vector<double>& said, const std::vector<double>& supports) {
  return measureOverOthers(supports, [&](std::size_t but) -> std::optional<double> {
    double sum = 0, weights = 0;
    for (std::size_t j = 0; j < said.size(); ++j)
      if (j != but) sum += supports[j] * said[j], weights += supports[j];
    if (weights == 0) return std::nullopt;
    return sum / weights;
  });
}

TEST(MeasureOverOthers, theRangeIsThatWithAnyOtherLeftOut) {
  const MeasuredValue found = meanOf({0, 1, 2, 6}, {0, 1, 1, 1});
  EXPECT_EQ(found.value, 3);
  EXPECT_EQ(found.low, 1.5) << "without the last";
  EXPECT_EQ(found.high, 4) << "without the first of the others";
  EXPECT_EQ(found.support, 3);
  EXPECT_TRUE(found.hasEnoughOthers);
}

TEST(MeasureOverOthers, aSingleOtherHasNoRangeAndIsNotEnough) {
  const MeasuredValue found = meanOf({0, 5, 7}, {0, 2, 0});
  EXPECT_EQ(found.value, 5);
  EXPECT_FALSE(found.low || found.high);
  EXPECT_FALSE(found.hasEnoughOthers);
}

TEST(MeasureOverOthers, withoutOthersThereIsNothing) {
  const MeasuredValue found = meanOf({1, 2}, {0, 0});
  EXPECT_FALSE(found.value);
  EXPECT_EQ(found.support, 0);
}

TEST(MeasureOverOthers, theRangeHoldsTheValueWhereLeavingOutGivesNone) {
  const auto onlyWhole = [](std::size_t but) {
    return but == 3 ? std::optional(2.0) : std::nullopt;
  };
  const MeasuredValue found = measureOverOthers({1, 1, 1}, onlyWhole);
  EXPECT_EQ(found.low, 2);
  EXPECT_EQ(found.high, 2);
}

}  // namespace
}  // namespace roomgraph
