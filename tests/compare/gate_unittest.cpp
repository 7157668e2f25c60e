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
  comparison.runs[0].score->score = 90, comparison.runs[0].score->isMeaningful = true;
  comparison.runs[0].measures = {{"coverage", kNearlyAll, "1", 100, {}, {}, true}};
  comparison.runs[1].name = "little";
  comparison.runs[1].measures = {{"bend", 0.1, "m", 100, {}, {}, true},
                                 {"coverage", kNearlyAll - 0.01, "1", 100, {}, {}, false}};
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
            (Lines{"little: its score cannot be told: too little to compare", "other: has no score",
                   "damaged: has no score"}));
  options.minScore = 90.1;
  EXPECT_EQ(gateVerdict(sample(), options).complaints.front(),
            "good: its score of 90.0 is 0.1 below 90.1");
}

TEST(Gate, aScoreThatNothingBacksDoesNotPass) {
  GateOptions options;
  options.minScore = 50;
  Comparison comparison = sample();
  comparison.runs[0].score->isMeaningful = false;
  EXPECT_EQ(gateVerdict(comparison, options).complaints.front(),
            "good: its score cannot be told: too little to compare");
}

TEST(Gate, aMapThatWasComparedWithNoneDoesNotPass) {
  GateOptions options;
  options.failsOnBreaks = true;
  Comparison comparison = sample();
  comparison.breaks.clear();
  EXPECT_TRUE(gateVerdict(comparison, options).isPassed());
  comparison.runs.resize(1);
  EXPECT_EQ(gateVerdict(comparison, options).complaints,
            Lines{"nothing was compared, as one map alone was left"});
}

TEST(Gate, coverageIsFoundByItsNameAndCountsAsItIs) {
  GateOptions options;
  options.failsOnCoverage = true;
  EXPECT_EQ(gateVerdict(sample(), options).complaints,
            Lines{"little: has seen 69 % of what at least two runs have seen, less than 70 %"});
}

TEST(Gate, whatIsWrongWithARunStandsTogether) {
  Comparison comparison = sample();
  comparison.breaks = {{"little", {1, 2}, 0.3, 0.9, {}, {}}, {"good", {1, 2}, 0.1, 0.5, {}, {}}};
  GateOptions options;
  options.failsOnBreaks = options.failsOnCoverage = true;
  const Lines lines = gateVerdict(comparison, options).complaints;
  ASSERT_EQ(lines.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(lines[i].rfind(i == 0 ? "good: breaks" : "little: ", 0), 0u) << lines[i];
}

TEST(Gate, aBreakIsToldWithItsKeyFrameAndTime) {
  GateOptions options;
  options.failsOnBreaks = true;
  Comparison comparison = sample();
  comparison.breaks[0].keyFrame = 47, comparison.breaks[0].time = 1.7e9;
  EXPECT_EQ(
      gateVerdict(comparison, options).complaints,
      Lines{"good: breaks at key frame 47, 2023-11-14T22:13:20Z, at (1.0, 2.0) by 5.7 degrees "
            "and 0.50 m (clear)"});
}

TEST(Gate, aSlightBreakIsNone) {
  GateOptions options;
  options.failsOnBreaks = true;
  Comparison comparison = sample();
  comparison.breaks[0].rotation = 0.08, comparison.breaks[0].shift = 0.3;
  EXPECT_TRUE(gateVerdict(comparison, options).isPassed());
}

TEST(Gate, aMapThatNobodyBearsOutDoesNotPass) {
  GateOptions options;
  options.failsOnUnconfirmed = true;
  Comparison comparison = sample();
  EXPECT_TRUE(gateVerdict(comparison, options).isPassed());
  comparison.runs[0].score->confirmed = 0.699;
  EXPECT_EQ(gateVerdict(comparison, options).complaints,
            Lines{"good: is confirmed by others in 69 % of what it has drawn, less than 70 %"});
  comparison.runs[0].score->confirmed = 0.99, comparison.runs[0].score->contradicted = 0.002;
  EXPECT_EQ(gateVerdict(comparison, options).complaints,
            Lines{"good: has drawn 1 % that others contradict, and that fits nowhere else"});
}

TEST(Gate, aSmearedMapBreaksAtEachKeyFrame) {
  GateOptions options;
  options.failsOnBreaks = true;
  Comparison comparison = sample();
  comparison.breaks.clear();
  comparison.runs[0].score->jitter = 0.09;
  EXPECT_TRUE(gateVerdict(comparison, options).isPassed());
  comparison.runs[0].score->jitter = 0.14;
  EXPECT_EQ(
      gateVerdict(comparison, options).complaints,
      Lines{"good: is smeared: its key frames are off by 0.14 m, independently of each other"});
}

TEST(Gate, coverageIsRoundedToItsSideOfTheLimit) {
  GateOptions options;
  options.failsOnCoverage = true;
  Comparison comparison = sample();
  comparison.runs[1].measures = {{"coverage", 1, "1", 100, {}, {}, true}};
  EXPECT_EQ(gateVerdict(comparison, options).margins,
            Lines{"good: has seen 70 % of what at least two runs have seen, no less than 70 %"});
  comparison.runs[0].measures[0].value = 0.6999;
  EXPECT_EQ(gateVerdict(comparison, options).complaints,
            Lines{"good: has seen 69 % of what at least two runs have seen, less than 70 %"});
}

TEST(Gate, breaksAndOtherSitesAreNamed) {
  GateOptions options;
  options.failsOnBreaks = options.failsOnOtherSites = true;
  EXPECT_EQ(gateVerdict(sample(), options).complaints,
            (Lines{"good: breaks at (1.0, 2.0) by 5.7 degrees and 0.50 m (clear)",
                   "other: is not of the same site (is of another site)"}));
}

/** Runs a to e with these map errors; the last one cannot be trusted. */
Comparison fiveRuns() {
  Comparison comparison;
  for (const double error : {0.1, 0.2, 0.4, 0.9, 0.05}) {
    ComparedRun run;
    run.name = std::string(1, char('a' + comparison.runs.size()));
    run.score = RunScore{};
    run.score->mapError = error, run.score->isMeaningful = error != 0.05;
    comparison.runs.push_back(run);
  }
  return comparison;
}

TEST(Gate, mapErrorsMustBeSmallAndTold) {
  GateOptions options;
  options.maxError = 0.4;
  EXPECT_EQ(gateVerdict(fiveRuns(), options).complaints,
            (Lines{"d: its map error of 0.900 m is 0.500 m above 0.4 m",
                   "e: its map error cannot be told: too little to compare"}));
}

TEST(Gate, ofADoubtfulPlaceTheWholeIntervalCounts) {
  GateOptions options;
  options.maxError = 0.4, options.candidates = {"b"};
  Comparison comparison = fiveRuns();
  ComparedRun& run = comparison.runs[1];
  run.score->errorHigh = 0.5;
  EXPECT_TRUE(gateVerdict(comparison, options).isPassed());
  ComparedPair& unsure = comparison.pairs.emplace_back();
  unsure.a = "a", unsure.b = "b", unsure.isSameSite = true, unsure.confidence = 0.5;
  ASSERT_EQ(comparison.certaintyOf(run), Certainty::doubtful);
  EXPECT_EQ(gateVerdict(comparison, options).complaints,
            Lines{"b: its map error is 0.200 m, but doubtful: it may be 0.500 m, 0.100 m above "
                  "0.4 m"});
}

TEST(Gate, metresOfAScaleThatNoMapTellsAreNotJudged) {
  Comparison comparison = sample();
  GateOptions options;
  options.maxError = 100;
  options.candidates = {"good"};
  comparison.runs[0].score->isMeaningful = true;
  EXPECT_TRUE(gateVerdict(comparison, options).isPassed());
  for (ComparedRun& run : comparison.runs) run.isScaleEstimated = true;
  EXPECT_EQ(gateVerdict(comparison, options).complaints,
            Lines{"good: its map error cannot be told in metres, as no map tells its scale: give "
                  "--resolution"});
}

TEST(Gate, aPassNamesTheRunThatCameClosestToEachLimit) {
  GateOptions options;
  options.maxError = 1;
  options.minScore = 40;
  Comparison comparison = fiveRuns();
  comparison.runs.pop_back();
  comparison.runs[1].score->score = 50;
  EXPECT_EQ(gateVerdict(comparison, options).margins,
            (Lines{"d: its map error of 0.900 m is 0.100 m below 1 m",
                   "b: its score of 50.0 is 10.0 above 40"}));
  comparison.runs[1].score->score = 30;
  EXPECT_TRUE(gateVerdict(comparison, options).margins.empty()) << "it fails";
}

TEST(Gate, aCandidateIsHeldAgainstTheBestThreeOthers) {
  GateOptions options;
  options.candidates = {"d"};
  options.maxWorse = 0.7;  // the median of 0.1, 0.2 and 0.4 is 0.2
  EXPECT_EQ(gateVerdict(fiveRuns(), options).margins,
            Lines{"d: its map error of 0.900 m is 0.700 m more than the median of the three best "
                  "others (limit: 0.7 m)"});
  options.maxWorse = 0.69;
  EXPECT_EQ(gateVerdict(fiveRuns(), options).complaints,
            Lines{"d: its map error of 0.900 m is 0.700 m more than the median of the three best "
                  "others (limit: 0.69 m)"});
  EXPECT_EQ(gateVerdict(fiveRuns(), options).candidates, Lines{"d"});
}

TEST(Gate, aRecordOfFewerThanThreeIsToldAsSuch) {
  GateOptions options;
  options.candidates = {"d", "c"}, options.maxWorse = 0.7;
  const Lines ofTwo = gateVerdict(fiveRuns(), options).complaints;
  EXPECT_EQ(ofTwo, Lines{"d: its map error of 0.900 m is 0.750 m more than the median of the two "
                         "best others (limit: 0.7 m)"});
  options.candidates.push_back("b");
  const Lines ofOne = gateVerdict(fiveRuns(), options).complaints;
  EXPECT_EQ(ofOne, Lines{"d: its map error of 0.900 m is 0.800 m more than that of the best other "
                         "(limit: 0.7 m)"});
}

TEST(Gate, onlyCandidatesAreJudgedAndTheyAreNotTheRecord) {
  GateOptions options;
  options.candidates = {"a"};
  options.maxError = 0.1;
  options.failsOnBreaks = options.failsOnOtherSites = true;
  Comparison comparison = fiveRuns();
  comparison.breaks = {{"d", {1, 2}, 0.1, 0.5, {}, {}}};
  comparison.leftOut = {{"other", "other.gridmap", "is of another site", true}};
  EXPECT_TRUE(gateVerdict(comparison, options).isPassed());
}

TEST(Gate, aCandidateWithoutALimitPassesWithAWord) {
  GateOptions options;
  options.candidates = {"d"};
  EXPECT_EQ(gateVerdict(fiveRuns(), options).margins,
            Lines{"d: no limit is set, so any map that can be judged passes"});
}

TEST(Gate, aCandidateThatIsNotComparedIsNeverGood) {
  GateOptions options;
  options.candidates = {"other"};
  EXPECT_FALSE(options.asksNothing());
  EXPECT_EQ(gateVerdict(sample(), options).complaints,
            Lines{"other: is not of the same site (is of another site)"});
  options.candidates = {"damaged"};
  EXPECT_EQ(gateVerdict(sample(), options).complaints, Lines{"damaged: could not be read"});
  options.candidates = {"good"};
  Comparison untold = sample();
  untold.runs[0].score->isMeaningful = false;
  EXPECT_EQ(gateVerdict(untold, options).complaints,
            Lines{"good: its map error cannot be told: too little to compare"});
}

/** Three runs, the first with these walls. */
Comparison withWalls(double missing, double added, double sharpness) {
  Comparison comparison = fiveRuns();
  comparison.runs.resize(3);
  for (ComparedRun& run : comparison.runs)
    run.measures = {{"walls_missing", 0.01, "1", 5000, {}, {}, true},
                    {"walls_added", 0.02, "1", 5000, {}, {}, true},
                    {"wall_sharpness", 0.8, "1", 5000, {}, {}, true}};
  std::vector<Measure>& first = comparison.runs[0].measures;
  first[0].value = missing, first[1].value = added, first[2].value = sharpness;
  first[1].place = Point{1, -2};
  return comparison;
}

TEST(Gate, wallsMustBeThereAndNoneThatOthersHaveNotAndAsThick) {
  GateOptions options;
  options.failsOnWalls = true;
  EXPECT_FALSE(options.asksNothing());
  EXPECT_TRUE(gateVerdict(withWalls(0.14, 0.49, 0.5), options).isPassed());
  EXPECT_EQ(
      gateVerdict(withWalls(0.3, 0.6, 0.2), options).complaints,
      (Lines{"a: lacks 30 % of the walls that two others have, more than 15 %",
             "a: has a place round (1.0, -2.0) where 60 % of the walls stand in free space of the "
             "others, more than 50 %",
             "a: its walls are too thin: 0.20 cells of wall for each cell at the edge of free "
             "space (wall_sharpness), where the others have 0.80"}));
  EXPECT_EQ(
      gateVerdict(withWalls(0, 0, 3), options).complaints,
      Lines{"a: its walls are too thick: 3.00 cells of wall for each cell at the edge of free "
            "space (wall_sharpness), where the others have 0.80"});
  EXPECT_EQ(gateVerdict(withWalls(0.152, 0.4, 0.8), options).complaints,
            Lines{"a: lacks 16 % of the walls that two others have, more than 15 %"})
      << "one sees that it is more";
  Comparison sound = withWalls(0, 0, 0.8);
  for (ComparedRun& run : sound.runs) run.measures[1].value = 0, run.measures[1].place.reset();
  EXPECT_EQ(gateVerdict(sound, options).margins,
            Lines{"b: lacks 1 % of the walls that two others have, no more than 15 %"});
  Comparison planned = withWalls(0, 0, 5);  // a plan, with its walls filled
  planned.reference = "a";
  EXPECT_TRUE(gateVerdict(planned, options).isPassed());
  Comparison little = withWalls(0.3, 0.4, 0.8);
  for (Measure& measure : little.runs[0].measures) measure.isMeaningful = false;
  EXPECT_TRUE(gateVerdict(little, options).isPassed()) << "nobody can tell";
}

TEST(Gate, noMapPassesForWantOfAFigureThatTakesTwoOthers) {
  GateOptions options;
  options.failsOnWalls = options.failsOnCoverage = true;
  Comparison two = withWalls(0, 0, 0.8);
  two.runs.resize(2);
  for (ComparedRun& run : two.runs) {
    run.measures.push_back({"coverage", 1, "1", 5000, {}, {}, true});
    for (Measure& measure : run.measures) measure.isMeaningful = false;
  }
  const Lines lines = gateVerdict(two, options).complaints;
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0], "a: its coverage cannot be told: that takes two other maps");
  EXPECT_EQ(lines[1], "a: what walls it lacks cannot be told: that takes two other maps");
  Comparison three = withWalls(0, 0, 0.8);
  three.runs[0].measures[0].isMeaningful = false;
  three.runs[0].score->isMeaningful = false;
  options.failsOnCoverage = false;
  EXPECT_EQ(gateVerdict(three, options).complaints,
            Lines{"a: what walls it lacks cannot be told: too little to compare"});
}

TEST(Gate, aCopyOfTheRecordIsNoCandidate) {
  Comparison comparison = fiveRuns();
  comparison.pairs.resize(1);
  comparison.pairs[0].a = "a", comparison.pairs[0].b = "b", comparison.pairs[0].areCopies = true;
  GateOptions options;
  options.candidates = {"b"};
  EXPECT_EQ(gateVerdict(comparison, options).complaints,
            Lines{"b: is a copy of a, which is of the record"});
  options.candidates = {"a", "b"};
  EXPECT_TRUE(gateVerdict(comparison, options).isPassed()) << "both are new";
  options.candidates.clear(), options.maxError = 1;
  EXPECT_EQ(gateVerdict(comparison, options).complaints.size(), 1u) << "e alone";
}

TEST(Gate, nothingToJudgeIsNoPass) {
  GateOptions options;
  options.failsOnBreaks = true;
  EXPECT_EQ(gateVerdict({}, options).complaints, Lines{"no run is left to be judged"});
}

}  // namespace
}  // namespace roomgraph
