#include "roomgraph/compare/record_error.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** Runs a to e with these map errors; the last one cannot be trusted. */
Comparison fiveRuns() {
  Comparison comparison;
  for (const double error : {0.1, 0.2, 0.4, 0.9, 0.05}) {
    comparison.runs.emplace_back();
    comparison.runs.back().name = std::string(1, char('a' + comparison.runs.size() - 1));
    comparison.runs.back().score = RunScore{};
    comparison.runs.back().score->mapError = error;
    comparison.runs.back().score->isMeaningful = error != 0.05;
  }
  return comparison;
}

TEST(RecordError, isTheMedianOfTheBestThreeOthers) {
  EXPECT_EQ(recordError(fiveRuns(), "d", {"d"})->error, 0.2);
  EXPECT_EQ(recordError(fiveRuns(), "d", {"d"})->runs, 3u);
  EXPECT_EQ(recordError(fiveRuns(), "a", {})->error, 0.4);
}

TEST(RecordError, candidatesAreNotOfIt) {
  EXPECT_EQ(recordError(fiveRuns(), "a", {"a", "b", "c"})->error, 0.9);
  EXPECT_FALSE(recordError(fiveRuns(), "a", {"b", "c", "d"})) << "only one that cannot be trusted";
}

TEST(TrustedError, isNoneWhereNothingBacksIt) {
  EXPECT_EQ(trustedError(fiveRuns().runs[1]), 0.2);
  EXPECT_FALSE(trustedError(fiveRuns().runs[4]));
  EXPECT_FALSE(trustedError({}));
}

}  // namespace
}  // namespace roomgraph
