#include "roomgraph/base/rounded.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

TEST(Rounded, keepsATenthOfAMillimetre) {
  EXPECT_DOUBLE_EQ(rounded(1.23456), 1.2346);
  EXPECT_EQ(rounded(rounded(1.23456)), rounded(1.23456));
  EXPECT_FALSE(std::signbit(rounded(-0.00004))) << "never -0";
}

}  // namespace
}  // namespace roomgraph
