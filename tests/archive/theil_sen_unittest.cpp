#include "roomgraph/archive/theil_sen.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

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

}  // namespace
}  // namespace roomgraph
