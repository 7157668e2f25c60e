#include "page_summary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sample_comparison.h"

namespace roomgraph {
namespace {

using test::kHostileName;
using test::sample;

bool isSaid(const Comparison& comparison, const std::string& sentence) {
  const std::vector<std::string> said = pageSummary(comparison);
  return std::count(said.begin(), said.end(), sentence) == 1;
}

TEST(PageSummary, saysWhatStandsOut) {
  const std::vector<std::string> said = pageSummary(sample().comparison);
  const std::string name = kHostileName;
  EXPECT_EQ(said,
            (std::vector<std::string>{
                "Navigation with morning: good enough with a localisation that corrects itself; "
                "probably also for docking, and for goals and zones that robots share. It has no "
                "break, and its map error is about 0.05 m, and most likely no more than 0.13 m.",
                "Why morning: its walls lie near those of the 3 other runs.",
                "1 map breaks: " + name +
                    ", from key frame 12 on, by 4.0 degrees and 0.58 m. 1 slight break is listed, "
                    "too.",
                "1 room is missing where a run has looked: R3 in " + name + ".",
                "1 file is left out: garage."}));
  EXPECT_TRUE(pageSummary({}).empty());
}

TEST(PageSummary, aRunThatIsRefutedIsNamed) {
  Comparison comparison = sample().comparison;
  comparison.runs[0].welded = {8, 201};
  EXPECT_TRUE(isSaid(comparison,
                     "morning has drawn key frames 8 and 201 at one place, though they see through "
                     "each other's walls."));
}

TEST(PageSummary, pairsOfLowConfidenceAreNamed) {
  Comparison comparison = sample().comparison;
  comparison.pairs[1].confidence = 0.68;
  const std::vector<std::string> said = pageSummary(comparison);
  EXPECT_EQ(std::count(said.begin(), said.end(),
                       "1 pair was aligned with a confidence below 0.9: check morning "
                       "on " +
                           std::string(kHostileName) + " (0.68)."),
            1);
}

TEST(PageSummary, manyNamesAreCounted) {
  Comparison comparison;
  for (int i = 1; i <= 5; ++i)
    comparison.leftOut.push_back({"m" + std::to_string(i), "", "", false});
  EXPECT_TRUE(isSaid(comparison, "5 files are left out: m1, m2, m3, m4 and m5."));
  comparison.leftOut.push_back({"m6", "", "", false});
  EXPECT_TRUE(isSaid(comparison, "6 files are left out: m1, m2, m3, m4 and 2 more."));
}

TEST(PageSummary, aRunThatBreaksOnceIsNamedWithoutANumber) {
  Comparison comparison = sample().comparison;
  comparison.breaks.resize(1);
  comparison.breaks[0].run = "evening";
  EXPECT_TRUE(isSaid(comparison,
                     "1 map breaks: evening, from key frame 12 on, by 4.0 degrees and 0.58 m."));
  comparison.breaks.resize(3, comparison.breaks[0]);
  comparison.breaks[0].run = "west";
  comparison.breaks[0].shift = 3, comparison.breaks[0].rotation = -0.1;
  comparison.breaks[0].keyFrame = 47;
  EXPECT_TRUE(isSaid(comparison,
                     "2 maps break: evening (2 places) and west. The largest break: west from "
                     "key frame 47 on, by 5.7 degrees and 3.00 m."));
  comparison.breaks[0].keyFrame.reset();
  EXPECT_TRUE(isSaid(comparison,
                     "2 maps break: evening (2 places) and west. The largest break: west, by "
                     "5.7 degrees and 3.00 m."));
}

TEST(PageSummary, roomsThatAreGoneAreNamedWithTheRunsThatLooked) {
  Comparison comparison = sample().comparison;
  comparison.rooms[1].runs[0].sighting = comparison.rooms[1].runs[1].sighting = RoomSighting::gone;
  comparison.rooms[2].runs[2].sighting = RoomSighting::seen;
  EXPECT_TRUE(
      isSaid(comparison, "1 room is missing where a run has looked: R2 in morning and evening."));
}

TEST(PageSummary, aGateIsToldWithWhatWasAsked) {
  Comparison comparison = sample().comparison;
  const std::string verdict = comparison.verdict;
  EXPECT_EQ(pageVerdict(comparison), verdict);
  comparison.gate = GateVerdict{{}, {"west"}, {"a score of 50 at least"}};
  EXPECT_EQ(pageVerdict(comparison), verdict);
  EXPECT_TRUE(isSaid(comparison, "The gate of west passes (a score of 50 at least)."));
  comparison.gate->complaints = {"west: breaks", "west: has too little"};
  EXPECT_EQ(pageVerdict(comparison), "The gate fails. " + verdict);
  EXPECT_TRUE(isSaid(comparison,
                     "The gate of west fails (a score of 50 at least): west: breaks; and "
                     "has too little."));
  comparison.gate = GateVerdict{{}, {}, {}};
  EXPECT_TRUE(isSaid(comparison, "The gate passes."));
}

TEST(PageSummary, aReferenceAndACoreAreNamed) {
  Comparison comparison = sample().comparison;
  comparison.reference = "plan";
  EXPECT_TRUE(isSaid(comparison, "All runs are measured against plan."));
  comparison.core = {"morning", "evening"};
  EXPECT_TRUE(isSaid(comparison,
                     "The consensus is that of 2 runs, the core; each other run is held against "
                     "it."));
}

TEST(PageSummary, ofTwoRunsNoneIsGivenAReason) {
  Comparison comparison = sample().comparison;
  comparison.runs.resize(2);
  for (const std::string& sentence : pageSummary(comparison))
    EXPECT_NE(sentence.rfind("Why ", 0), 0u) << sentence;
}

TEST(PageSummary, pairsOfOtherSitesAreNotDoubtful) {
  Comparison comparison = sample().comparison;
  for (ComparedPair& pair : comparison.pairs) pair.isSameSite = false, pair.confidence = 0.1;
  for (const std::string& sentence : pageSummary(comparison))
    EXPECT_EQ(sentence.find("confidence below"), std::string::npos) << sentence;
}

TEST(PageCounts, oneIsNotMany) {
  Comparison comparison;
  comparison.runs.resize(1);
  EXPECT_EQ(pageCounts(comparison), "1 run of one site, 0 pairs");
  comparison.runs.resize(2);
  comparison.runs[0].name = "a", comparison.runs[1].name = "b";
  comparison.pairs.resize(2);
  comparison.pairs[0].a = "a", comparison.pairs[0].b = "b";
  comparison.pairs[1].a = "a", comparison.pairs[1].b = "stranger";
  comparison.rooms.resize(1);
  EXPECT_EQ(pageCounts(comparison), "2 runs of one site, 1 pair, 1 room");
}

Comparison bestWith(double error, double high) {
  Comparison comparison;
  comparison.runs.resize(2);
  comparison.runs[0].name = "best", comparison.runs[0].rank = 1;
  RunScore score;
  score.mapError = error, score.errorHigh = high, score.isMeaningful = true, score.share = 1;
  comparison.runs[0].score = score;
  return comparison;
}

bool starts(const std::string& text, const std::string& with) { return text.rfind(with, 0) == 0; }

TEST(NavigationWord, goesByTheErrorAndItsInterval) {
  EXPECT_EQ(
      navigationWord(bestWith(0.02, 0.08)),
      "Navigation with best: good enough, also for docking, and for goals and zones that robots "
      "share. It has no break, and its map error is about 0.02 m, and most likely no more than "
      "0.08 m.");
  Comparison oneDrive = bestWith(0.02, 0.08);
  oneDrive.isOneDrive = true;
  EXPECT_TRUE(starts(navigationWord(oneDrive),
                     "Navigation with best: good enough with a localisation that corrects itself; "
                     "probably also for docking"));
  EXPECT_TRUE(starts(navigationWord(bestWith(0.08, 0.15)),
                     "Navigation with best: good enough with a localisation that corrects itself; "
                     "probably also for docking"));
  EXPECT_TRUE(
      starts(navigationWord(bestWith(0.2, 0.4)),
             "Navigation with best: good enough with a localisation that corrects itself, and "
             "for lengths and areas; not for docking"));
  EXPECT_TRUE(starts(navigationWord(bestWith(0.5, 0.9)), "Navigation with best: perhaps"));
}

TEST(NavigationWord, doesNotTakeAScaleForKnownThatNoMapTells) {
  Comparison comparison = bestWith(0.02, 0.08);
  for (ComparedRun& run : comparison.runs) run.isScaleEstimated = true;
  EXPECT_EQ(navigationWord(comparison),
            "Navigation with best: cannot be told in metres, as no map tells its scale.");
  comparison.runs[1].isScaleEstimated = false;  // of which that of the others was estimated
  EXPECT_TRUE(starts(navigationWord(comparison), "Navigation with best: good enough"));
}

TEST(NavigationWord, aBreakIsNeverGoodEnough) {
  Comparison comparison = bestWith(0.01, 0.02);
  comparison.breaks = {{"other", {}, 0.1, 0.5, {}, {}}};
  EXPECT_TRUE(starts(navigationWord(comparison), "Navigation with best: good enough, "));
  comparison.breaks[0].run = "best";
  EXPECT_TRUE(
      starts(navigationWord(comparison), "Navigation with best: not good enough. It breaks"));
}

TEST(NavigationWord, theBestRunWithoutABreakIsNamedForDriving) {
  Comparison comparison = bestWith(0.01, 0.02);
  comparison.runs[1] = comparison.runs[0];
  comparison.runs[1].name = "sound", comparison.runs[1].score->mapError = 0.05;
  comparison.breaks = {{"best", {}, 0.1, 0.5, {}, {}}};
  EXPECT_NE(
      navigationWord(comparison)
          .find(" To drive: sound, which has no break, and its map error is about 0.05 m, and "
                "most likely no more than 0.02 m; to measure: best."),
      std::string::npos)
      << navigationWord(comparison);
  comparison.runs[1].score->isMeaningful = false;
  EXPECT_EQ(navigationWord(comparison).find("To drive"), std::string::npos);
}

TEST(NavigationWord, wallsThatNoOtherHasAreNoBadAlignment) {
  Comparison comparison = bestWith(0, 0.02);
  comparison.runs[0].measures = {{"walls_added", 0.6, "1", 5000, {}, {}, true, Point{1, 2}}};
  EXPECT_EQ(navigationWord(comparison),
            "Navigation with best: cannot be told, not all of it is confirmed by other runs.");
}

TEST(NavigationWord, doubtIsNeverGoodEnough) {
  Comparison comparison = bestWith(0, 0.02);
  comparison.pairs.resize(1);
  comparison.pairs[0].a = "best", comparison.pairs[0].isSameSite = true;
  comparison.pairs[0].confidence = 0.6;
  EXPECT_EQ(
      navigationWord(comparison),
      "Navigation with best: cannot be told, as no reliable alignment links it to most of the "
      "others.");
}

TEST(NavigationWord, saysNothingOfMapsThatCannotBeJudged) {
  EXPECT_EQ(navigationWord({}), "");
  Comparison comparison = bestWith(0.01, 0.02);
  comparison.runs[0].score->isMeaningful = false;
  EXPECT_EQ(navigationWord(comparison),
            "Navigation with best: cannot be told, there is too little to judge by.");
  comparison.runs[0].score.reset();
  EXPECT_EQ(navigationWord(comparison), "");
}

}  // namespace

}  // namespace roomgraph
