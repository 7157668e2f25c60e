#include "roomgraph/report/comparison_json.h"

#include <gtest/gtest.h>

#include "refusal.h"
#include "roomgraph/report/comparison_csv.h"
#include "roomgraph/report/gate_report.h"
#include "sample_comparison.h"
#include "schemas.h"

namespace roomgraph {
namespace {

/** With all that can be there, or not. */
Comparison sample() {
  Comparison comparison = test::sampleComparison().comparison;
  comparison.runs[1].score.reset(), comparison.runs[1].rank = 0;
  comparison.runs[2].isScaleEstimated = true, comparison.runs[2].sha256 = "abc";
  comparison.pairs[1].transform.reset(), comparison.pairs[2].runnerUp.reset();
  comparison.reference = comparison.runs[1].name;
  comparison.isOneDrive = true, comparison.referenceDoubled = 1.25;
  comparison.core = {comparison.runs[0].name, comparison.runs[1].name, comparison.runs[2].name};
  comparison.options.push_back({"compare", "aligned", "true", "", ""});
  comparison.options.push_back({"compare", "reference", "plan.png", "", ""});
  comparison.gate = GateVerdict{{"west: has no score"}, {"west"}, {"a score of 50 at least"}};
  comparison.files = {"report.html", "comparison.json"};
  comparison.rooms[0].doors = {{{1, 2}, 0.9, "C1", {"morning", "evening"}, {"west"}}};
  return comparison;
}

TEST(ParseComparisonJson, givesBackAllThatWasWritten) {
  for (const Comparison& comparison : {sample(), Comparison()}) {
    const std::string text = comparisonJson(comparison);
    const Comparison again = parseComparisonJson(text, "comparison.json");
    EXPECT_EQ(comparisonJson(again), text);
    EXPECT_EQ(again.files, comparison.files);
    EXPECT_EQ(again.core, comparison.core);
    EXPECT_EQ(again.isOneDrive, comparison.isOneDrive);
    EXPECT_EQ(again.referenceDoubled, comparison.referenceDoubled);
    ASSERT_EQ(again.rooms.size(), comparison.rooms.size());
    if (!again.rooms.empty()) {
      EXPECT_EQ(again.rooms[0].doors[0].seenIn, comparison.rooms[0].doors[0].seenIn);
      EXPECT_EQ(again.rooms[0].doors[0].lostIn, comparison.rooms[0].doors[0].lostIn);
    }
    ASSERT_EQ(again.breaks.size(), comparison.breaks.size());
    for (std::size_t i = 0; i < again.breaks.size(); ++i)
      EXPECT_EQ(bool(again.breaks[i].torn), bool(comparison.breaks[i].torn));
    for (std::size_t i = 0; i < again.runs.size(); ++i)
      EXPECT_EQ(again.runs[i].path.size(), comparison.runs[i].path.size());
    EXPECT_EQ(comparisonRunsCsv(again), comparisonRunsCsv(comparison));
    EXPECT_EQ(comparisonRoomsCsv(again), comparisonRoomsCsv(comparison));
  }
}

TEST(ParseComparisonJson, whatARunHasWeldedIsKept) {
  Comparison comparison = sample();
  comparison.runs[1].welded = {8, 201};
  const std::string json = comparisonJson(comparison);
  EXPECT_EQ(test::schemaComplaint("comparison", json), "");
  const Comparison again = parseComparisonJson(json, "c.json");
  EXPECT_EQ(again.runs[1].welded, comparison.runs[1].welded);
  EXPECT_FALSE(again.runs[2].welded);
}

TEST(ParseComparisonJson, whereAMapLayIsKeptIfItIsTold) {
  Comparison comparison = sample();
  EXPECT_EQ(comparisonJson(comparison).find("relative_path"), std::string::npos);
  comparison.runs[0].relativePath = "../maps/a.simplemap";
  const Comparison again = parseComparisonJson(comparisonJson(comparison), "comparison.json");
  EXPECT_EQ(again.runs[0].relativePath, "../maps/a.simplemap");
  EXPECT_EQ(again.runs[1].relativePath, "");
}

TEST(ParseComparisonJson, theMarginsOfAGateAreKept) {
  Comparison comparison = sample();
  comparison.gate = GateVerdict{{}, {}, {"no break"}, {"a: has no break"}};
  const Comparison again = parseComparisonJson(comparisonJson(comparison), "comparison.json");
  EXPECT_EQ(again.gate->margins, comparison.gate->margins);
}

TEST(ComparisonText, aNameStaysOnItsLine) {
  Comparison comparison = sample();
  const std::string before = comparisonText(comparison);
  comparison.runs[2].name = "a\nb\x1b[31m";
  comparison.rooms[2].runs[2].run = comparison.runs[2].name;
  const std::string text = comparisonText(comparison);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'),
            std::count(before.begin(), before.end(), '\n'));
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("a?b?[31m"), std::string::npos);
}

TEST(ComparisonText, saysWhichRunTheOthersAreMeasuredAgainst) {
  Comparison comparison = sample();
  EXPECT_NE(comparisonText(comparison).find("  reference\n"), std::string::npos);
  comparison.reference.reset();
  EXPECT_EQ(comparisonText(comparison).find("  reference\n"), std::string::npos);
}

TEST(ComparisonText, isTheSameOfTheFile) {
  Comparison comparison = sample();
  comparison.runs[0].score->mapError = 0.0815, comparison.runs[0].score->score = 84.95;
  comparison.runs[0].measures.assign(1, {"coverage", 0.91496, "1", 1, {}, {}, true});
  const Comparison again = parseComparisonJson(comparisonJson(comparison), "comparison.json");
  EXPECT_EQ(comparisonText(again), comparisonText(comparison));
  EXPECT_EQ(gateMarkdown(again), gateMarkdown(comparison));
  EXPECT_NE(comparisonText(comparison).find(" 0.082 "), std::string::npos);
  EXPECT_FALSE(again.runs[0].measures[0].place);
}

TEST(ComparisonJson, keepsThePlaceOfAFigure) {
  Comparison comparison = sample();
  comparison.runs[0].measures.assign(1, {"walls_added", 0.3, "1", 1, {}, {}, true, Point{1, -2}});
  const Comparison again = parseComparisonJson(comparisonJson(comparison), "comparison.json");
  ASSERT_TRUE(again.runs[0].measures[0].place);
  EXPECT_NEAR(distance(*again.runs[0].measures[0].place, {1, -2}), 0, 1e-9);
}

TEST(ParseComparisonJson, knowsWhatAnOptionIs) {
  const Comparison again = parseComparisonJson(comparisonJson(sample()), "comparison.json");
  for (const UsedOption& option : again.options) EXPECT_NE(option.sentence, "") << option.name;
}

TEST(ParseComparisonJson, saysWhereAFileIsBroken) {
  const std::string good = comparisonJson(sample());
  const auto complaint = [](const std::string& text) {
    return test::refusalOf([&] { parseComparisonJson(text, "c.json"); });
  };
  const auto with = [&](const std::string& old, const std::string& replacement) {
    std::string text = good;
    text.replace(text.find(old), old.size(), replacement);
    return complaint(text);
  };
  EXPECT_NE(with("\"meaningful\":true", "\"meaningful\":1").find("runs[0]"), std::string::npos);
  EXPECT_NE(with("\"sighting\":\"seen\"", "\"sighting\":\"lost\"").find("rooms[0].runs[0]"),
            std::string::npos);
  EXPECT_NE(with("\"error_m\":null", "\"error_m\":true").find("runs[0].path[0].error_m"),
            std::string::npos);
  EXPECT_NE(with("\"pose_untorn\":[", "\"pose_untorn\":[1,").find("breaks[0].pose_untorn"),
            std::string::npos);
  EXPECT_NE(with("\"version\": 1,", "\"version\": 2,").find("version"), std::string::npos);
  EXPECT_NE(with("\"gate\"", "\"gat\"").find("has no 'gate'"), std::string::npos);
  EXPECT_NE(complaint(good.substr(0, good.size() / 2)), "");
  EXPECT_NE(complaint("{\"format\": \"roomgraph/graph\"}"), "");
}

}  // namespace
}  // namespace roomgraph
