#include "roomgraph/report/gate_report.h"

#include <gtest/gtest.h>

#include "occurrences.h"

namespace roomgraph {
namespace {

using test::has;

Comparison twoRuns() {
  Comparison comparison;
  comparison.runs.resize(2);
  comparison.runs[0].name = "a", comparison.runs[0].rank = 1;
  comparison.runs[0].score = RunScore{};
  comparison.runs[0].score->mapError = 0.05, comparison.runs[0].score->isMeaningful = true;
  comparison.runs[1].name = "b <&\"|*>\n";
  comparison.leftOut = {{"c", "c.gridmap", "ends too early", false}};
  comparison.verdict = "a is the best";
  return comparison;
}

TEST(GateJunit, aTestForEachRunFailsWithItsComplaints) {
  Comparison comparison = twoRuns();
  comparison.gate =
      GateVerdict{{"b <&\"|*>\n: breaks", "b <&\"|*>\n: is bad", "c: no score"}, {}, {}};
  const std::string text = gateJunit(comparison);
  EXPECT_TRUE(has(
      text, "<testsuite name=\"roomgraph\" tests=\"3\" failures=\"2\" errors=\"0\" skipped=\"0\""))
      << text;
  EXPECT_TRUE(has(text, "name=\"a\"/>\n")) << text;
  EXPECT_TRUE(
      has(text, "name=\"b &lt;&amp;&quot;|*&gt;?\">\n   <failure message=\"breaks; is bad\"/>"))
      << text;
}

TEST(GateJunit, onlyTheCandidatesAreTests) {
  Comparison comparison = twoRuns();
  comparison.gate = GateVerdict{{}, {"a"}, {"no break"}};
  comparison.leftOut.front().isOtherSite = true;
  EXPECT_TRUE(has(gateJunit(comparison), "tests=\"1\" failures=\"0\""));
}

TEST(GateJunit, whatCouldNotBeReadFailsAndAnotherSiteIsSkipped) {
  Comparison comparison = twoRuns();
  comparison.leftOut.push_back({"d", "d.gridmap", "is of another site", true});
  comparison.gate = GateVerdict{{}, {}, {"no break"}};
  const std::string text = gateJunit(comparison);
  EXPECT_TRUE(has(text, "tests=\"4\" failures=\"1\" errors=\"0\" skipped=\"1\"")) << text;
  EXPECT_TRUE(has(text, "name=\"c\">\n   <failure message=\"ends too early\"/>")) << text;
  EXPECT_TRUE(has(text, "name=\"d\">\n   <skipped message=\"is of another site\"/>")) << text;
  comparison.gate = GateVerdict{{}, {"a"}, {"no break"}};
  EXPECT_TRUE(has(gateJunit(comparison), "tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"0\""));
}

TEST(GateJunit, whatIsSaidOfNoRunIsATestOfItsOwn) {
  Comparison comparison = twoRuns();
  comparison.gate = GateVerdict{{"no run is left to be judged"}, {}, {}};
  EXPECT_TRUE(has(gateJunit(comparison), "name=\"gate\">\n   <failure message=\"no run is left"));
  EXPECT_TRUE(has(gateJunit(Comparison{}), "name=\"gate\"/>"));
}

TEST(GateMarkdown, hasVerdictsAndARowForEachRun) {
  Comparison comparison = twoRuns();
  comparison.gate = GateVerdict{{"b <&\"|*>\n: breaks"}, {}, {"no break"}};
  const std::string text = gateMarkdown(comparison);
  EXPECT_TRUE(has(text, "## The gate fails\n\nCriteria: no break.\n\n- b")) << text;
  EXPECT_TRUE(has(text, "breaks\n\na is the best\n\n| rank")) << text;
  comparison.gate->complaints = {"a: has no score", "a: breaks", "a: has seen little"};
  const std::string failing = gateMarkdown(comparison);
  EXPECT_TRUE(has(failing, "| **has no score** and 2 more |\n")) << failing;
  comparison.gate = GateVerdict{{}, {"a"}, {"no break"}, {"a: has no break"}};
  const std::string passing = gateMarkdown(comparison);
  EXPECT_EQ(passing.find("## The gate passes: a\n\nCriteria: no break.\n\n- a: has no break\n"), 0u)
      << passing;
  comparison.gate.reset();
  const std::string ungated = gateMarkdown(comparison);
  EXPECT_EQ(ungated.find("## 2 maps compared\n\na is the best\n\n| rank"), 0u);
  EXPECT_TRUE(has(ungated, "| 100 (likely) | not judged |\n")) << ungated;
  EXPECT_TRUE(has(text, "| 1 | a | 0.050 | 0.000 to 0.000 | 100 (likely) | passes |\n")) << text;
  EXPECT_TRUE(has(text, "| - | b \\<\\&\"\\|\\*\\>? |")) << text;
  EXPECT_TRUE(has(text, "left out: ends too early |\n")) << text;
}

TEST(GateReport, runsThatWereCheckedAloneHaveARowAndATestEach) {
  std::vector<RunCheck> checks(2);
  checks[0].name = "a", checks[0].selfError = 0.0514, checks[0].seenTwice = 0.7;
  checks[1].name = "b|", checks[1].complaints = {"it breaks in 1 place"};
  checks[1].breaks.resize(1), checks[1].doubled.resize(2), checks[1].welded.resize(1);
  const std::string markdown = gateMarkdown(checks, {"c.simplemap"});
  const std::string junit = gateJunit(checks, {"c.simplemap"});
  EXPECT_TRUE(has(markdown, "| a | 0.051 | 70 % | 0 | 0 | 0 | passes |\n")) << markdown;
  EXPECT_TRUE(has(markdown, "| b\\| | - | 0 % | 1 | 2 | 1 | **it breaks in 1 place** |\n"))
      << markdown;
  EXPECT_TRUE(has(markdown, "| c.simplemap | - | - | - | - | - | **it could not be read** |\n"))
      << markdown;
  EXPECT_TRUE(has(junit, "tests=\"3\" failures=\"2\"")) << junit;
}

}  // namespace
}  // namespace roomgraph
