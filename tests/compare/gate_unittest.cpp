#include "roomgraph/compare/gate.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace roomgraph {
namespace {

using Lines = std::vector<std::string>;

/** A good run, one without a score and with little coverage, and a reference; one is left out. */
Comparison sample() {
  Comparison comparison;
  comparison.runs.resize(3);
  comparison.runs[0].name = "good", comparison.runs[0].score = RunScore{};
  comparison.runs[0].score->score = 90;
  comparison.runs[0].measures = {{"coverage", kPartialCoverage, "1", 100, {}, {}, true}};
  comparison.runs[1].name = "little";
  comparison.runs[1].measures = {{"bend", 0.1, "m", 100, {}, {}, true},
                                 {"coverage", kPartialCoverage - 0.01, "1", 100, {}, {}, false}};
  comparison.runs[2].name = "plan";
  comparison.reference = "plan";
  comparison.leftOut = {{"other", "other.gridmap", "is of another site", true},
                        {"damaged", "damaged.gridmap", "ends too early", false}};
  comparison.breaks = {{"good", {1, 2}, 0.1, 0.5, {}, {}}};
  return comparison;
}

TEST(Gate, passesWhereNothingIsAsked) {
  EXPECT_TRUE(GateOptions{}.asksNothing());
  EXPECT_TRUE(gateVerdict(sample(), {}).isPassed());
}

TEST(Gate, eachRunMustHaveItsScoreButTheReference) {
  GateOptions options;
  options.minScore = 90;
  EXPECT_EQ(gateVerdict(sample(), options).complaints,
            (Lines{"little: has no score", "other: has no score", "damaged: has no score"}));
  options.minScore = 90.1;
  EXPECT_EQ(gateVerdict(sample(), options).complaints.front(),
            "good: its score is below --fail-below");
}

TEST(Gate, coverageIsFoundByItsNameAndCountsAsItIs) {
  GateOptions options;
  options.failsOnCoverage = true;
  EXPECT_EQ(gateVerdict(sample(), options).complaints,
            Lines{"little: has seen less than 70 % of what two runs have seen"});
}

TEST(Gate, breaksAndOtherSitesAreNamed) {
  GateOptions options;
  options.failsOnBreaks = options.failsOnOtherSites = true;
  EXPECT_EQ(gateVerdict(sample(), options).complaints,
            (Lines{"good: is broken at (1.0, 2.0) by 5.7 degrees and 0.50 m",
                   "other: is not of the same site"}));
}

}  // namespace
}  // namespace roomgraph
