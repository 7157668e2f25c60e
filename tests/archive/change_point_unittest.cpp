#include "roomgraph/archive/change_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

Samples samplesOf(const std::vector<double>& values) {
  Samples samples;
  for (const double value : values) samples.push_back({double(samples.size()), value});
  return samples;
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
