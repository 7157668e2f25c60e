#include "page_tables.h"

#include <gtest/gtest.h>

#include "mustache_values.h"
#include "sample_comparison.h"

namespace roomgraph {
namespace {

using test::sample;

/** What a template makes of the tables. */
std::string shown(const Comparison& comparison, const std::string& text) {
  return kainjow::mustache::mustache(text).render(mustacheValues(pageTables(comparison)));
}

TEST(PageTables, runsStandInTheOrderOfTheirRanks) {
  EXPECT_EQ(shown(sample().comparison, "{{#runs}}{{rank}}:{{error}}[{{errorRange}}] {{/runs}}"),
            "1:0.05[0.03 – 0.13] 2:0.11[0.06 – 0.25] 3:0.70[0.35 – 1.43] 4:1.20[0.60 – 2.43] ");
  Comparison comparison = sample().comparison;
  EXPECT_EQ(shown(comparison, "{{#runs}}{{breaks}} {{/runs}}"), "0 0 1 + 1 slight 0 ");
  comparison.breaks[1].shift = 0.6;
  EXPECT_EQ(shown(comparison, "{{#runs}}{{breaks}} {{/runs}}"), "0 0 2 0 ");
  comparison.breaks[1].shift = 0.3;
  comparison.breaks[0] = comparison.breaks[1];
  EXPECT_EQ(shown(comparison, "{{#runs}}{{breaks}} {{/runs}}"), "0 0 2 slight 0 ");
  EXPECT_EQ(shown(sample().comparison, "{{#runs}}{{coverage}} {{/runs}}"), "90 % 80 % 70 % 60 % ");
}

TEST(PageTables, aRunWithoutAScoreHasDashes) {
  Comparison comparison = sample().comparison;
  comparison.runs[3].score.reset(), comparison.runs[3].rank = 0;
  comparison.reference = comparison.runs[3].name;
  EXPECT_EQ(shown(comparison,
                  "{{#runs}}{{#isReference}}{{rank}} {{score}} {{error}}"
                  "[{{errorRange}}]{{/isReference}}{{/runs}}"),
            "– – –[]");
}

TEST(PageTables, measuresStandUnderTheirNames) {
  const Comparison& comparison = sample().comparison;
  EXPECT_EQ(shown(comparison, "{{#measureNames}}{{name}}{{unit}};{{/measureNames}}"),
            "Coverage;Wall distance, median[m];");
  EXPECT_EQ(shown(comparison, "{{#runs}}{{#measures}}{{value}}({{range}}){{/measures}};{{/runs}}"),
            "90 %(50 – 90)0.02(0.01 – 0.03);80 %(50 – 90)0.04(0.03 – 0.06);"
            "70 %(50 – 90)0.23(0.17 – 0.35);60 %(50 – 90)0.40(0.30 – 0.60);");
  EXPECT_EQ(
      shown(comparison, "{{#runs}}{{#measures}}{{#weak}}weak{{/weak}}{{/measures}};{{/runs}}"),
      ";;;weak;");
}

TEST(PageTables, aMeasureThatOneRunLacksLeavesItsCellEmpty) {
  Comparison comparison = sample().comparison;
  comparison.runs[1].measures.erase(comparison.runs[1].measures.begin());
  EXPECT_EQ(shown(comparison, "{{#runs}}{{#measures}}{{value}} {{/measures}};{{/runs}}"),
            "90 % 0.02 ;– 0.04 ;70 % 0.23 ;60 % 0.40 ;");
}

TEST(PageTables, aMeasureOfALaterVersionKeepsItsOwnName) {
  Comparison comparison = sample().comparison;
  for (ComparedRun& run : comparison.runs)
    run.measures.push_back({"warmth", 3, "K", 10, {}, {}, true});
  EXPECT_EQ(shown(comparison, "{{#measureNames}}{{name}}{{unit}};{{/measureNames}}"),
            "Coverage;Wall distance, median[m];warmth[K];");
}

TEST(PageTables, datesAreFromTheFirstScanToTheLastWithTheDayOnce) {
  Comparison comparison = sample().comparison;
  EXPECT_EQ(shown(comparison, "{{#runs}}{{dates}};{{/runs}}"),
            "2017-07-14T02:39:48Z – 02:40:07Z;2017-07-14T02:39:48Z – 02:40:07Z;"
            "2017-07-14T02:39:48Z – 02:40:07Z;–;");
  comparison.runs[0].path.back().time = 1.5e9 + 86400;
  comparison.runs[1].path[0].time.reset();
  EXPECT_EQ(shown(comparison, "{{#runs}}{{dates}};{{/runs}}").substr(0, 83),
            "2017-07-14T02:39:48Z – 2017-07-15T02:40:00Z;2017-07-14T02:39:49Z – 02:40:07Z;20");
}

TEST(PageTables, breaksAreToldInDegreesWithTheirKeyFrames) {
  EXPECT_EQ(shown(sample().comparison,
                  "{{#breaks}}{{index}}:{{x}},{{y}} {{turn}} {{shift}} "
                  "{{frame}} {{time}};{{/breaks}}"),
            "0:8.0,6.0 4.0 0.58 12 2017-07-14T02:40:00Z;1:12.0,9.0 -2.9 0.30 – –;");
}

TEST(PageTables, pairsThatAreUnsureAreMarked) {
  Comparison comparison = sample().comparison;
  comparison.pairs[0].confidence = 0.7;
  comparison.pairs[1].transform.reset();
  comparison.pairs[2].runnerUp.reset();
  EXPECT_EQ(shown(comparison,
                  "{{#pairs}}{{confidence}}{{#doubtful}}!{{/doubtful}} {{overlap}} "
                  "{{distance}} {{runnerUp}}{{^same}} other{{/same}};{{/pairs}}"),
            "0.70! 80 % 0.11 0.01;0.97 – 0.11 0.01;0.40 80 % 0.11 – other;0.97 80 % 0.11 0.01;"
            "0.40 80 % 0.11 0.01 other;0.40 80 % 0.11 0.01 other;");
}

TEST(PageTables, atFirstNoMoreThanADozenRunsAreShown) {
  Comparison comparison = sample().comparison;
  comparison.breaks.clear();
  while (comparison.runs.size() < 20) comparison.runs.push_back(comparison.runs[1]);
  EXPECT_EQ(shown(comparison, "{{#runs}}{{#isShown}}x{{/isShown}}{{/runs}}"), std::string(12, 'x'));
}

TEST(PageTables, longTablesStartClosed) {
  Comparison comparison = sample().comparison;
  const std::string flags =
      "{{#runsAreMany}}many{{/runsAreMany}}{{#pairsAreFew}}few{{/pairsAreFew}}";
  EXPECT_EQ(shown(comparison, flags), "few");
  comparison.runs.resize(31), comparison.pairs.resize(61);
  EXPECT_EQ(shown(comparison, flags), "many");
}

TEST(PageTables, filesAreNamedWithoutTheirFolders) {
  EXPECT_EQ(shown(sample().comparison, "{{#leftOut}}{{name}} {{file}}: {{reason}}{{/leftOut}}"),
            "garage garage.gridmap: does not lie in the same site as the others");
  const std::string files = shown(sample().comparison, "{{#runs}}{{file}};{{/runs}}");
  EXPECT_EQ(files.rfind("morning.gridmap;evening.gridmap;", 0), 0u) << files;
}

TEST(PageTables, optionsHaveTheirSections) {
  Comparison comparison = sample().comparison;
  comparison.options.push_back({"", "alone", "1", "", ""});
  EXPECT_EQ(shown(comparison, "{{#options}}{{key}}={{value}}{{unit}};{{/options}}"),
            "split_at_doors.max_width=1.5m;alone=1;");
}

TEST(PageTables, theScaleOfTheHeatMapRises) {
  const std::string scale = shown({}, "{{#heat}}{{upTo}} {{/heat}}");
  EXPECT_EQ(scale.rfind("10 20 30 ", 0), 0u) << scale;
}

TEST(PageTables, ofNothingTheTablesAreEmpty) {
  EXPECT_EQ(shown({},
                  "{{#runs}}run{{/runs}}{{#breaks}}break{{/breaks}}{{#hasRooms}}r{{/hasRooms}}"
                  "{{#hasPairs}}p{{/hasPairs}}{{#hasLeftOut}}l{{/hasLeftOut}}"),
            "");
}

}  // namespace
}  // namespace roomgraph
