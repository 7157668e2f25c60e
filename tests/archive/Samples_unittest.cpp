#include <gtest/gtest.h>

#include <cmath>

#include "roomgraph/archive/watch_errors.h"

namespace roomgraph {
namespace {

Samples samplesOf(const std::vector<double>& values) {
  Samples samples;
  for (const double value : values) samples.push_back({double(samples.size()), value});
  return samples;
}

TEST(MannKendall, tenValuesThatRiseAreNoChance) {
  const double pRising = mannKendall(samplesOf({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  // S = 45, variance 125, z = 44 / sqrt(125) = 3.935
  EXPECT_NEAR(pRising, 4.15e-5, 1e-6);
}

TEST(MannKendall, valuesThatFallDoNotRise) {
  const double pRising = mannKendall(samplesOf({5, 4, 3, 2, 1}));
  EXPECT_GT(pRising, 0.95);
}

TEST(MannKendall, equalValuesTakeTheirShareOfTheVariance) {
  // S = 8 of 10 pairs; variance (5*4*15 - 2*1*9 - 2*1*9) / 18 = 14.667; z = 7 / 3.830
  const double pRising = mannKendall(samplesOf({1, 1, 2, 2, 3}));
  EXPECT_NEAR(pRising, 0.0338, 1e-4);
}

TEST(MannKendall, fewOrEqualValuesHaveNoTrend) {
  EXPECT_DOUBLE_EQ(mannKendall({}), 0.5);
  EXPECT_DOUBLE_EQ(mannKendall(samplesOf({1, 2})), 0.5);
  EXPECT_DOUBLE_EQ(mannKendall(samplesOf({2, 2, 2, 2})), 0.5);
}

TEST(TheilSen, aLineIsFoundExactly) {
  const auto fit = theilSen({{1, 5}, {2, 7}, {4, 11}, {5, 13}});
  ASSERT_TRUE(fit);
  EXPECT_DOUBLE_EQ(fit->perDay, 2);
  EXPECT_DOUBLE_EQ(fit->at0, 3);
  EXPECT_DOUBLE_EQ(fit->at(10), 23);
}

TEST(TheilSen, oneBadNightDoesNotMoveIt) {
  Samples samples;
  for (int day = 0; day < 9; ++day) samples.push_back({double(day), 0.1});
  samples[7].value = 50;
  const auto fit = theilSen(samples);
  ASSERT_TRUE(fit);
  EXPECT_DOUBLE_EQ(fit->perDay, 0);
  EXPECT_DOUBLE_EQ(fit->at0, 0.1);
}

TEST(TheilSen, samplesOfOneTimeHaveNoSlope) {
  EXPECT_FALSE(theilSen({}));
  EXPECT_FALSE(theilSen({{3, 1}}));
  EXPECT_FALSE(theilSen({{3, 1}, {3, 2}}));
  const auto fit = theilSen({{3, 1}, {3, 3}, {5, 6}});  // slopes 2.5 and 1.5
  ASSERT_TRUE(fit);
  EXPECT_DOUBLE_EQ(fit->perDay, 2);
}

TEST(ChangePoint, aStepIsFoundAtItsNight) {
  std::vector<double> values(20, 0.1);
  for (std::size_t i = 12; i < values.size(); ++i) values[i] = 0.2;
  values[5] = 7;  // a bad night
  const auto found = changePoint(samplesOf(values));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, 12U);
  EXPECT_DOUBLE_EQ(found->before, 0.1);
  EXPECT_DOUBLE_EQ(found->after, 0.2);
  EXPECT_LT(found->p, 0.05);
}

TEST(ChangePoint, theProbabilityIsPettitts) {
  // Ranks 1 to 6: the sums less their mean are -2.5, -4, -4.5, ...; K = 9.
  const auto found = changePoint(samplesOf({1, 2, 3, 4, 5, 6}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, 3U);
  EXPECT_NEAR(found->p, 2 * std::exp(-6 * 81.0 / (216 + 36)), 1e-12);
}

TEST(ChangePoint, oneBadNightIsNoChange) {
  std::vector<double> values(30, 0.1);
  values[15] = 9;
  const auto found = changePoint(samplesOf(values));
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->p, 1);
}

TEST(ChangePoint, equalValuesHaveNone) {
  EXPECT_FALSE(changePoint({}));
  EXPECT_FALSE(changePoint(samplesOf({1})));
  EXPECT_FALSE(changePoint(samplesOf({2, 2, 2})));
}

}  // namespace
}  // namespace roomgraph
