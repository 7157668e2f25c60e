#include "explain_comparison.h"

#include <gtest/gtest.h>

#include <tuple>

#include "occurrences.h"

namespace roomgraph {
namespace {

ComparedRun scored(const std::string& name, double error) {
  ComparedRun run;
  run.name = name;
  run.score.emplace();
  run.score->mapError = error, run.score->score = 100 - 100 * error;
  run.score->low = run.score->score - 5, run.score->high = run.score->score + 5;
  run.score->share = 0.9, run.score->others = 2, run.score->isMeaningful = true;
  run.measures.push_back({"bend", 0.3, "m", 500, {}, {}, true});
  return run;
}

ComparedPair copyOf(const std::string& a, const std::string& b) {
  ComparedPair pair;
  pair.a = a, pair.b = b, pair.areCopies = true;
  return pair;
}

Comparison ofRuns(const std::vector<ComparedRun>& runs) {
  Comparison comparison;
  comparison.runs = runs;
  return comparison;
}

TEST(ReasonOf, saysHowFarTheWallsLieOff) {
  const Comparison three = ofRuns({scored("a", 0.1), scored("b", 0.2), scored("c", 0.3)});
  EXPECT_EQ(reasonOf(three.runs[1], three),
            "its walls lie 0.20 m RMS from the consensus of 3 runs");
  Comparison alone = three;
  alone.runs[1].score->others = 0;
  EXPECT_TRUE(test::has(reasonOf(alone.runs[1], alone), "the consensus of 1 run"));
  EXPECT_FALSE(test::has(reasonOf(alone.runs[1], alone), "1 runs"));
  Comparison measured = three;
  measured.reference = "plan";
  EXPECT_EQ(reasonOf(measured.runs[0], measured), "its walls lie 0.10 m RMS from the reference");
}

TEST(ReasonOf, roundsWhatComparisonJsonHolds) {
  const Comparison comparison = ofRuns({scored("a", 0.02496), scored("b", 0.2), scored("c", 0.3)});
  EXPECT_EQ(reasonOf(comparison.runs[0], comparison),
            "its walls lie 0.03 m RMS from the consensus of 3 runs")
      << "0.0250, of which the tables and the page make 0.03";
}

TEST(ReasonOf, saysWhatNobodyBearsOut) {
  Comparison comparison = ofRuns({scored("a", 0.1), scored("b", 0.2), scored("c", 0.3)});
  RunScore& score = *comparison.runs[0].score;
  score.confirmed = 0.8;
  EXPECT_TRUE(test::has(reasonOf(comparison.runs[0], comparison),
                        "; 20 % of what it has drawn no other run confirms"));
  score.contradicted = 0.2;
  EXPECT_TRUE(test::has(reasonOf(comparison.runs[0], comparison),
                        "; others contradict 20 % of what it has drawn, and show it nowhere else"));
  score.jitter = 0.14;
  EXPECT_TRUE(test::has(reasonOf(comparison.runs[0], comparison),
                        "; its key frames are off by 0.14 m, independently of each other"));
}

TEST(VerdictOf, aMapThatNobodyBearsOutIsNotTheBest) {
  Comparison comparison = ofRuns({scored("a", 0.01), scored("b", 0.2), scored("c", 3)});
  ASSERT_EQ(verdictOf(comparison).find("a is the best map"), 0u);
  Comparison unconfirmed = comparison, smeared = comparison, disputed = comparison;
  unconfirmed.runs[0].score->confirmed = 0.6;
  EXPECT_EQ(verdictOf(unconfirmed).find("a has the smallest error"), 0u);
  EXPECT_TRUE(test::has(verdictOf(unconfirmed), "But a is confirmed by others in 60 % of what"));
  smeared.runs[0].score->jitter = 0.12;
  EXPECT_EQ(verdictOf(smeared).find("a has the smallest error"), 0u);
  disputed.runs[0].score->isScaleDisputed = true;
  EXPECT_EQ(verdictOf(disputed).find("a has the smallest error"), 0u);
  Comparison oneDrive = comparison, outdone = comparison;
  oneDrive.isOneDrive = true;
  EXPECT_EQ(verdictOf(oneDrive).find("a has the smallest error, with"), 0u);
  outdone.runs[2].score->isMeaningful = false, outdone.runs[2].score->mapError = 0.001;
  EXPECT_EQ(verdictOf(outdone).find("a has the smallest error of those that can be judged"), 0u);
  EXPECT_EQ(
      scalesNote({"a", "b"}, {"c"}, 1.02),
      " a and b are 2.0 % larger than c; the runs cannot show which scale is right, but a floor "
      "plan as --reference can.");
}

TEST(ReasonOf, namesWhatSpeaksAgainstARun) {
  Comparison torn = ofRuns({scored("a", 0.1), scored("b", 0.2)});
  torn.breaks.resize(3);
  torn.breaks[0].run = torn.breaks[2].run = "b", torn.breaks[1].run = "a";
  for (MapBreak& one : torn.breaks) one.shift = 0.5;
  torn.runs[1].score->share = 0.35, torn.runs[1].score->isMeaningful = false;
  EXPECT_TRUE(test::has(reasonOf(torn.runs[0], torn), "; it breaks in 1 place"));
  EXPECT_TRUE(
      test::has(reasonOf(torn.runs[1], torn),
                "; it breaks in 2 places; only 35 % of its walls were found in the other maps; "
                "too little to judge by"));
}

TEST(ReasonOf, saysHowFarTheScaleIsOff) {
  Comparison comparison = ofRuns({scored("a", 0.1), scored("b", 0.4)});
  const std::string without = reasonOf(comparison.runs[0], comparison);
  comparison.runs[0].score->scale = 0.962;
  EXPECT_EQ(reasonOf(comparison.runs[0], comparison), without + "; it is 3.8 % too small");
  comparison.runs[0].score->isScaleDisputed = true;
  EXPECT_EQ(reasonOf(comparison.runs[0], comparison), without) << "either may be right";
}

TEST(ReasonOf, saysWhyThereIsNoScore) {
  Comparison comparison = ofRuns({scored("a", 0.1), {}, {}});
  comparison.runs[1].name = "plan", comparison.reference = "plan";
  comparison.runs[1].isScaleEstimated = true, comparison.runs[1].resolution = 0.0432;
  EXPECT_EQ(reasonOf(comparison.runs[1], comparison),
            "the others are measured against it; 0.0432 m per cell, estimated");
  comparison.runs[2].name = "alone";
  EXPECT_EQ(reasonOf(comparison.runs[2], comparison),
            "none of its walls could be followed in another run");
  Comparison single = ofRuns({{}});
  EXPECT_EQ(reasonOf(single.runs[0], single), "no other run to compare it with");
}

TEST(VerdictOf, namesTheBestAndThoseThatMayBeAsGood) {
  EXPECT_EQ(verdictOf(ofRuns({scored("a", 0.1), scored("b", 0.4), scored("c", 0.5)})),
            "a is the best map, with score 90.0 (85.0 to 95.0) and a map error of about 0.10 m.");
  EXPECT_TRUE(test::has(verdictOf(ofRuns({scored("a", 0.1), scored("b", 0.15), scored("c", 0.5)})),
                        "; b may be as good."));
  EXPECT_TRUE(test::has(verdictOf(ofRuns({scored("a", 0.1), scored("b", 0.12), scored("c", 0.15)})),
                        "; b and c may be as good."));
}

TEST(ReasonOf, saysWherePlacesAreDoubtful) {
  Comparison comparison = ofRuns({scored("a", 0.1), scored("b", 0.2), scored("c", 0.3)});
  for (const auto& [a, b, confidence] :
       {std::tuple{"a", "b", 0.99}, {"a", "c", 0.5}, {"b", "c", 0.6}}) {
    ComparedPair pair;
    pair.a = a, pair.b = b, pair.isSameSite = true, pair.confidence = confidence;
    comparison.pairs.push_back(pair);
  }
  const std::string doubt = "; doubtful, as no reliable alignment links it to most of the others";
  EXPECT_FALSE(test::has(reasonOf(comparison.runs[0], comparison), doubt));
  EXPECT_TRUE(test::has(reasonOf(comparison.runs[2], comparison), doubt));
  EXPECT_EQ(verdictOf(comparison).rfind("a is the best map", 0), 0u);
  comparison.pairs[0].confidence = 0.7;
  const std::string said = verdictOf(comparison);
  EXPECT_EQ(said.rfind("a has the smallest error", 0), 0u) << said;
  EXPECT_TRUE(test::has(
      said, "m; b may be as good. But a has no reliable alignment to most of the others."))
      << said;
}

TEST(VerdictOf, aRunThatMayBeTheWorstIsNotCalledTheBest) {
  Comparison unsure = ofRuns({scored("a", 0.1), scored("b", 0.4), scored("c", 0.5)});
  unsure.runs[0].score->low = 40;
  EXPECT_EQ(verdictOf(unsure).rfind("a has the smallest error", 0), 0u) << verdictOf(unsure);
}

TEST(VerdictOf, aReferenceThatIsFoundInPartsOnlyIsNamed) {
  Comparison broken = ofRuns({scored("a", 0.1), scored("b", 0.4), scored("c", 0.5)});
  broken.reference = "c";
  broken.runs[0].score->givenUp = 0.36, broken.runs[0].score->isMeaningful = false;
  const std::string said = "No run can be judged: a, with the smallest error (about 0.10 m), ";
  EXPECT_EQ(
      verdictOf(broken).rfind(said + "cannot be measured (36 % of what it and the reference", 0),
      0u)
      << verdictOf(broken);
  EXPECT_TRUE(
      test::has(reasonOf(broken.runs[0], broken), "; 36 % of what it and the reference found"));
  broken.runs[0].score->givenUp = 0.05;
  EXPECT_EQ(broken.faultOfReference(broken.runs[0]), "");
}

TEST(VerdictOf, aReferenceThatBreaksIsNamed) {
  Comparison broken = ofRuns({scored("a", 0.1), scored("b", 0.4), scored("c", 0.5)});
  broken.reference = "c";
  broken.breaks = {{"a", {}, 0.1, 0, 7, {}}, {"c", {}, 0.05, 0, 8, {}}};
  EXPECT_EQ(broken.faultOfReference(broken.runs[0]), "") << "a slight one";
  broken.breaks.push_back({"c", {}, M_PI / 30, 0.3, 117, {}});
  const std::string fault =
      "the reference itself breaks at key frame 117, by 6.0 degrees and 0.30 m";
  EXPECT_EQ(broken.faultOfReference(broken.runs[0]), fault);
  EXPECT_TRUE(test::has(verdictOf(broken), "But a cannot be measured (" + fault + ")."))
      << verdictOf(broken);
  EXPECT_TRUE(test::has(reasonOf(broken.runs[1], broken), "; " + fault));
}

TEST(VerdictOf, aMapOfAPartIsNotCalledTheBest) {
  Comparison partial = ofRuns({scored("a", 0.1), scored("b", 0.4), scored("c", 0.5)});
  partial.runs[0].measures = {{"coverage", 0.42, "1", 5000, {}, {}, true}};
  const std::string said = verdictOf(partial);
  EXPECT_EQ(said.rfind("a has the smallest error", 0), 0u) << said;
  EXPECT_TRUE(test::has(said, " m. But a has seen only 42 % of what at least two runs have seen."))
      << said;
  partial.runs[0].score->isMeaningful = false;
  EXPECT_TRUE(test::has(verdictOf(partial), "two runs have seen and has too little to judge by."));
  partial.runs[0].score->isMeaningful = true;
  partial.runs[0].measures[0].isMeaningful = false;
  EXPECT_EQ(verdictOf(partial).rfind("a is the best map", 0), 0u) << "too little to say so";
}

TEST(VerdictOf, aMapWithAPlaceThatNoOtherShowsIsNotCalledTheBest) {
  Comparison wrong = ofRuns({scored("a", 0.1), scored("b", 0.4), scored("c", 0.5)});
  wrong.runs[0].measures = {{"walls_added", 0.62, "1", 5000, {}, {}, true, Point{1, 2}}};
  EXPECT_TRUE(test::has(verdictOf(wrong),
                        "But a has a place where others show no such walls, round "
                        "(1.0, 2.0)."))
      << verdictOf(wrong);
  EXPECT_FALSE(test::has(verdictOf(wrong), "best map"));
  EXPECT_TRUE(test::has(reasonOf(wrong.runs[0], wrong),
                        "round (1.0, 2.0) 62 % of its walls stand in free space of the others"));
}

TEST(VerdictOf, oneRunBesideAReferenceIsNotRanked) {
  Comparison comparison = ofRuns({scored("a", 0.1), scored("b", 0.2)});
  comparison.reference = "b", comparison.runs[1].score.reset();
  EXPECT_EQ(verdictOf(comparison).rfind("a is about 0.10 m off the reference (", 0), 0u)
      << verdictOf(comparison);
}

TEST(VerdictOf, editsOfOneMapSayNothingMore) {
  Comparison edits = ofRuns({scored("a", 0.1), scored("b", 0.1), scored("c", 0.1)});
  edits.pairs.resize(1);
  edits.pairs[0].a = "b", edits.pairs[0].b = "c", edits.pairs[0].areEdits = true;
  edits.runs[0].score->isMeaningful = false;
  EXPECT_TRUE(test::has(verdictOf(edits),
                        "a, with the smallest error (about 0.10 m), can be compared with "
                        "one other map at most, as the rest are copies or edits."))
      << verdictOf(edits);
}

TEST(VerdictOf, aMapWithAPlaceThatNoOtherShowsIsNotAsGood) {
  Comparison close = ofRuns({scored("a", 0.1), scored("b", 0.1), scored("c", 0.5)});
  EXPECT_TRUE(test::has(verdictOf(close), "b may be as good")) << verdictOf(close);
  close.runs[1].measures = {{"walls_added", 0.62, "1", 5000, {}, {}, true, Point{1, 2}}};
  EXPECT_FALSE(test::has(verdictOf(close), "may be as good"));
}

TEST(VerdictOf, aMapThatMayLieInTheWrongPlaceIsNotAsGood) {
  Comparison close = ofRuns({scored("a", 0.1), scored("b", 0.1), scored("c", 0.5)});
  for (const auto& [one, other, confidence] :
       {std::tuple("a", "c", 1.0), std::tuple("a", "b", 0.5), std::tuple("b", "c", 0.5)}) {
    ComparedPair pair;
    pair.a = one, pair.b = other, pair.isSameSite = true, pair.confidence = confidence;
    close.pairs.push_back(pair);
  }
  ASSERT_EQ(close.certaintyOf(close.runs[1]), Certainty::doubtful);
  EXPECT_FALSE(test::has(verdictOf(close), "may be as good")) << verdictOf(close);
}

TEST(VerdictOf, copiesOfOneFileSayNothing) {
  Comparison copies = ofRuns({scored("a", 0.1), scored("a#2", 0.1), scored("a#3", 0.1)});
  copies.pairs = {copyOf("a", "a#2"), copyOf("a", "a#3"), copyOf("a#2", "a#3")};
  EXPECT_EQ(verdictOf(copies),
            "All 3 runs are copies of one file, which say nothing about each other.");
  EXPECT_EQ(copiesNote(copies), "") << "it is said already";
  EXPECT_TRUE(test::has(reasonOf(copies.runs[2], copies), "; a copy of a"));
  copies.pairs[0].areCopies = copies.pairs[2].areCopies = false;
  EXPECT_EQ(verdictOf(copies).rfind("a has the smallest error", 0), 0u) << verdictOf(copies);
  EXPECT_EQ(copiesNote(copies), " a#3 is a copy of a.");
}

TEST(VerdictOf, aReferenceIsComparedWithItsCopies) {
  Comparison copies = ofRuns({scored("a", 0), scored("plan", 0)});
  copies.pairs = {copyOf("a", "plan")}, copies.reference = "plan";
  EXPECT_EQ(verdictOf(copies).rfind("a ", 0), 0u) << verdictOf(copies);
}

TEST(Notes, editsCountAsOneDrive) {
  Comparison edits = ofRuns({scored("a", 0.1), scored("b", 0.1), scored("c", 0.1)});
  edits.pairs = {copyOf("a", "b")};
  edits.pairs[0].areCopies = false, edits.pairs[0].areEdits = true;
  EXPECT_EQ(copiesNote(edits), " 2 maps are edits of one (a and b), and count as one drive.");
}

TEST(VerdictOf, saysWhereNothingCanBeSaid) {
  EXPECT_TRUE(test::has(verdictOf({}), "nothing can be compared"));
  EXPECT_TRUE(test::has(verdictOf(ofRuns({{}, {}})), "no walls could be followed"));
  EXPECT_EQ(verdictOf(ofRuns({scored("a", 0.1), scored("b", 0.4)})),
            "Two runs cannot tell for sure which is better: they bend 0.30 m apart.");
}

TEST(Notes, saysWhereDrivesAreNotKnown) {
  EXPECT_EQ(unknownDrivesNote(2, 3).rfind(" 2 maps are without scans, so whether", 0), 0u);
  EXPECT_EQ(unknownDrivesNote(3, 3).rfind(" All maps are without scans, so whether", 0), 0u);
}

TEST(Notes, sayHowManyCellsAnErrorIsWhereNoMapTellsAScale) {
  Comparison comparison;
  EXPECT_EQ(usualScaleNote(comparison), "");
  comparison.runs.resize(2);
  for (ComparedRun& run : comparison.runs) run.resolution = 0.02, run.isScaleEstimated = true;
  EXPECT_TRUE(test::has(usualScaleNote(comparison), "so an error of 0.10 m stands for 5 cells"));
  comparison.runs[1].isScaleEstimated = false;
  EXPECT_EQ(usualScaleNote(comparison), "");
}

TEST(Notes, nameOtherSitesAndRunsOfOneDrive) {
  EXPECT_EQ(otherSitesNote({{"a", "b"}, {"c", "d"}}),
            " There are 2 sites, of which this compares the first: "
            "{a and b}, {c and d}.");
  EXPECT_EQ(sharedDriveNote({"a", "b"}, 3),
            " 2 runs are of one drive (a and b); errors that they share cannot be detected.");
  EXPECT_EQ(sharedDriveNote({"a", "b"}, 2),
            " Both runs are of one drive; errors that they share cannot be detected.");
}

}  // namespace
}  // namespace roomgraph
