#include "by_straightness.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

using Order = std::vector<std::size_t>;

/** A run that has seen so much, with walls that are so far from right angles. */
roomgraph::Run run(double freeArea, std::optional<double> axisDeviation) {
  roomgraph::Run run;
  run.map.freeArea = freeArea;
  run.map.axisDeviation = axisDeviation;
  return run;
}

TEST(ByStraightness, theStraightestLargeRunComesFirst) {
  EXPECT_EQ(byStraightness({run(90, 0.03), run(100, 0.02), run(60, 0.01)}), (Order{2, 1, 0}));
}

TEST(ByStraightness, whatHasSeenLessThanHalfOfTheLargestComesLast) {
  EXPECT_EQ(byStraightness({run(49, 0.001), run(100, 0.02), run(50, 0.03), run(10, 0.0001)}),
            (Order{1, 2, 3, 0}));
}

TEST(ByStraightness, runsOfWhichItCannotBeToldComeBehindTheOthersOfTheirGroup) {
  EXPECT_EQ(byStraightness({run(100, {}), run(80, 0.5), run(20, 0.1)}), (Order{1, 0, 2}));
}

TEST(ByStraightness, equalOnesKeepTheirOrder) {
  EXPECT_EQ(byStraightness({run(5, 0.1), run(5, 0.1), run(5, 0.1)}), (Order{0, 1, 2}));
  EXPECT_EQ(byStraightness({run(0, {}), run(0, {})}), (Order{0, 1}));
  EXPECT_TRUE(byStraightness({}).empty());
}

}  // namespace
}  // namespace roomgraph
