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

/** A room that these runs have, each in one piece and without a change. */
SiteRoom room(const std::string& id, const std::vector<std::string>& runs) {
  SiteRoom room;
  room.id = room.name = id;
  room.area = 12.34;
  for (const std::string& run : runs) {
    room.runs.emplace_back();
    room.runs.back().run = run, room.runs.back().sighting = RoomSighting::seen;
    room.runs.back().pieces = 1;
  }
  return room;
}

std::string shownRows(const std::vector<SiteRoom>& rooms, const std::string& text) {
  return kainjow::mustache::mustache("{{#rooms}}" + text + "{{/rooms}}")
      .render(mustacheValues({{"rooms", roomRows(rooms)}}));
}

TEST(RoomRows, aRoomThatAllHaveAlikeIsTheSame) {
  EXPECT_EQ(
      shownRows({room("R1", {"a", "b"})},
                "{{index}} {{id}} {{kind}} {{area}} {{seen}}/{{of}}{{#isSame}} same{{/isSame}}"),
      "0 R1 room 12.3 2/2 same");
}

TEST(RoomRows, aCorridorIsCalledSo) {
  SiteRoom corridor = room("C1", {"a"});
  corridor.isCorridor = true;
  EXPECT_EQ(shownRows({room("R1", {"a"}), corridor}, "{{index}}{{kind}} "), "0room 1corridor ");
}

TEST(RoomRows, aNameIsShownWhereItWasGiven) {
  SiteRoom kitchen = room("R2", {"a"}), blank = room("R3", {"a"});
  kitchen.name = "Kitchen <1>", blank.name = "";
  EXPECT_EQ(shownRows({room("R1", {"a"}), kitchen, blank}, "{{#hasName}}{{name}}{{/hasName}};"),
            ";Kitchen &lt;1&gt;;;");
}

TEST(RoomRows, sightingsAreCountedAndToldOneByOne) {
  SiteRoom some = room("R1", {"a", "b", "c", "d"});
  some.runs[1].sighting = RoomSighting::gone;
  some.runs[2].sighting = some.runs[3].sighting = RoomSighting::unvisited;
  EXPECT_EQ(shownRows({some},
                      "{{seen}}/{{of}} {{#hasGone}}{{gone}} gone{{/hasGone}}: "
                      "{{#dots}}{{kind}} {{/dots}}"),
            "1/4 1 gone: seen gone unvisited unvisited ");
  EXPECT_EQ(shownRows({some}, "{{#dots}}{{title}};{{/dots}}"),
            "a: seen;b: looked there, no such room;c: has not looked there;"
            "d: has not looked there;");
  EXPECT_EQ(shownRows({some}, "{{#isSame}}same{{/isSame}}"), "") << "not all have seen it";
}

TEST(RoomRows, manySightingsAreNoStripOfDots) {
  const auto isStrip = [](std::size_t runs) {
    return shownRows({room("R1", std::vector<std::string>(runs, "a"))},
                     "{{#isStrip}}strip{{/isStrip}}");
  };
  EXPECT_EQ(isStrip(16), "strip");
  EXPECT_EQ(isStrip(17), "");
}

TEST(RoomRows, theLargestShiftIsNamedWithItsRun) {
  SiteRoom moved = room("R1", {"a", "b", "c"});
  EXPECT_EQ(shownRows({moved}, "{{shift}}{{shiftRun}}"), "–");
  moved.runs[0].shift = 0.2, moved.runs[1].shift = 0.45, moved.runs[2].shift = 0.1;
  EXPECT_EQ(shownRows({moved}, "{{shift}} {{shiftRun}}"), "0.45 b");
}

TEST(RoomRows, changesAreCountedByRuns) {
  SiteRoom changed = room("R1", {"a", "b", "c"});
  changed.runs[0].pieces = 3;
  changed.runs[1].isMerged = changed.runs[2].isMerged = true;
  changed.runs[1].doorsGained = 2;
  changed.runs[0].doorsLost = changed.runs[2].doorsLost = 1;
  EXPECT_EQ(shownRows({changed}, "{{changes}}{{#isSame}}same{{/isSame}}"),
            "split in 1, merged in 2, new door in 1, lost door in 2");
}

TEST(RoomRows, ofNoRoomsThereAreNone) { EXPECT_EQ(shownRows({}, "x"), ""); }

}  // namespace
}  // namespace roomgraph
