#include "roomgraph/archive/mann_kendall.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

Samples samplesOf(const std::vector<double>& values) {
  Samples samples;
  for (const double value : values) samples.push_back({double(samples.size()), value});
  return samples;
}

TEST(MannKendall, tenValuesThatRiseAreNoChance) {
  const TrendTest test = mannKendall(samplesOf({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_DOUBLE_EQ(test.tau, 1);
  // S = 45, variance 125, z = 44 / sqrt(125) = 3.935
  EXPECT_NEAR(test.pRising, 4.15e-5, 1e-6);
}

TEST(MannKendall, valuesThatFallDoNotRise) {
  const TrendTest test = mannKendall(samplesOf({5, 4, 3, 2, 1}));
  EXPECT_DOUBLE_EQ(test.tau, -1);
  EXPECT_GT(test.pRising, 0.95);
}

TEST(MannKendall, equalValuesTakeTheirShareOfTheVariance) {
  // S = 8 of 10 pairs; variance (5*4*15 - 2*1*9 - 2*1*9) / 18 = 14.667; z = 7 / 3.830
  const TrendTest test = mannKendall(samplesOf({1, 1, 2, 2, 3}));
  EXPECT_DOUBLE_EQ(test.tau, 0.8);
  EXPECT_NEAR(test.pRising, 0.0338, 1e-4);
}

TEST(MannKendall, fewOrEqualValuesHaveNoTrend) {
  EXPECT_DOUBLE_EQ(mannKendall({}).pRising, 0.5);
  EXPECT_DOUBLE_EQ(mannKendall(samplesOf({1, 2})).pRising, 0.5);
  EXPECT_DOUBLE_EQ(mannKendall(samplesOf({2, 2, 2, 2})).pRising, 0.5);
}

}  // namespace
}  // namespace roomgraph
