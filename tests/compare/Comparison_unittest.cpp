#include "roomgraph/compare/Comparison.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

ComparedPair pairOf(const std::string& a, const std::string& b, double confidence) {
  ComparedPair pair;
  pair.a = a, pair.b = b, pair.isSameSite = true, pair.confidence = confidence;
  return pair;
}

ComparedRun runOf(const std::string& name, double error) {
  ComparedRun run;
  run.name = name, run.score.emplace();
  run.score->mapError = error;
  run.score->errorLow = error / 1.5, run.score->errorHigh = 1.5 * error;
  run.score->share = 0.9, run.score->isMeaningful = true;
  return run;
}

Comparison ofFour() {
  Comparison comparison;
  for (const char* name : {"a", "b", "c", "d"}) comparison.runs.push_back(runOf(name, 0.1));
  return comparison;
}

TEST(Comparison, aPlaceIsDoubtfulWhereNoChainOfSurePairsLeadsToMostOthers) {
  Comparison comparison = ofFour();
  EXPECT_FALSE(comparison.isPlaceDoubtful("a")) << "nothing speaks against it";
  comparison.pairs = {pairOf("a", "b", 0.99), pairOf("b", "c", 0.95), pairOf("a", "c", 0.4),
                      pairOf("a", "d", 0.8),  pairOf("b", "d", 0.3),  pairOf("c", "d", 0.3)};
  for (const char* name : {"a", "b", "c"}) EXPECT_FALSE(comparison.isPlaceDoubtful(name)) << name;
  EXPECT_TRUE(comparison.isPlaceDoubtful("d"));
  comparison.pairs[3].isSameSite = comparison.pairs[4].isSameSite = false;
  EXPECT_TRUE(comparison.isPlaceDoubtful("d")) << "one pair is left";
  comparison.pairs[5].isSameSite = false;
  EXPECT_FALSE(comparison.isPlaceDoubtful("d")) << "pairs of other sites do not count";
}

TEST(Comparison, oneBadRunLeavesNoDoubtOnSureOnes) {
  Comparison comparison = ofFour();
  comparison.pairs = {pairOf("a", "b", 0.95), pairOf("a", "c", 0.5), pairOf("a", "d", 0.5),
                      pairOf("b", "c", 0.5),  pairOf("b", "d", 0.5), pairOf("c", "d", 0.5)};
  EXPECT_FALSE(comparison.isPlaceDoubtful("a"));
  comparison.pairs[5].confidence = 0.95;
  EXPECT_FALSE(comparison.isPlaceDoubtful("a")) << "two halves of one size";
  comparison.pairs[0].confidence = 0.5;
  EXPECT_TRUE(comparison.isPlaceDoubtful("a"));
}

TEST(Comparison, certaintyNamesTheWorstDoubt) {
  Comparison comparison = ofFour();
  ComparedRun& a = comparison.runs[0];
  const auto word = [&] { return std::string(nameOf(comparison.certaintyOf(a))); };
  EXPECT_EQ(word(), "sure");
  a.score->share = 0.5;
  EXPECT_EQ(word(), "likely");
  a.score->share = 0.9, a.score->errorHigh = 0.31;
  EXPECT_EQ(word(), "likely");
  a.score->errorHigh = 4, a.score->mapError = 3, a.score->errorLow = 0.1;
  EXPECT_EQ(word(), "likely") << "and down to 0";
  a.score->errorHigh = 0.1, a.score->mapError = 0.1,
  a.measures = {{"coverage", 0.4, "1", 5000, {}, {}, true}};
  EXPECT_EQ(word(), "likely");
  comparison.pairs = {pairOf("a", "b", 0.5)};
  EXPECT_EQ(word(), "doubtful");
  a.score->isMeaningful = false;
  EXPECT_EQ(word(), "cannot tell");
}

TEST(Comparison, aPlaceIsSureWhereTheOthersBearItOut) {
  Comparison comparison = ofFour();
  comparison.pairs = {pairOf("a", "b", 0.5)};
  ComparedRun& a = comparison.runs[0];
  EXPECT_TRUE(comparison.isPlaceDoubtful("a")) << "it has no scans";
  a.path.emplace_back();
  EXPECT_TRUE(comparison.isPlaceDoubtful("a")) << "of two runs either may lie wrong";
  a.score->others = 2;
  EXPECT_FALSE(comparison.isPlaceDoubtful("a"));
  EXPECT_EQ(comparison.certaintyOf(a), Certainty::sure);
  a.score->share = 0.49;
  EXPECT_TRUE(comparison.isPlaceDoubtful("a")) << "most of it was not found";
  a.score->share = 0.9, a.score->contradicted = 0.01;
  EXPECT_TRUE(comparison.isPlaceDoubtful("a"));
  a.score->contradicted = 0, a.score->errorHigh = 4;
  EXPECT_TRUE(comparison.isPlaceDoubtful("a")) << "another place may be right";
}

TEST(Comparison, aLargeErrorExplainsWallsInFreeSpace) {
  ComparedRun run = runOf("a", 0.2);
  run.measures = {{"straight_walls_added", 0.1, "1", 5000, {}, {}, true, Point{1, 2}}};
  run.path.emplace_back(), run.score->others = 2;
  EXPECT_EQ(Comparison{}.certaintyOf(run), Certainty::doubtful);
  run.score->mapError = 0.4, run.score->errorLow = 0.3, run.score->errorHigh = 0.6;
  EXPECT_EQ(Comparison{}.certaintyOf(run), Certainty::likely);
}

TEST(Comparison, slightBreaksAreNotCounted) {
  Comparison comparison = ofFour();
  comparison.breaks = {{"a", {}, kClearRotation, 0, {}, {}},
                       {"b", {}, 0, kBreakShift, {}, {}},
                       {"a", {}, kBreakRotation, 0, {}, {}}};
  EXPECT_EQ(comparison.countBreaks("a"), 1u);
  EXPECT_EQ(comparison.countBreaks("b"), 1u);
  EXPECT_EQ(comparison.countBreaks("c"), 0u);
}

TEST(Comparison, coverageIsPartialWhereItIsSmallAndMeaningful) {
  ComparedRun run = runOf("a", 0.1);
  EXPECT_FALSE(run.partialCoverage());
  run.measures.emplace_back();
  Measure& coverage = run.measures.back();
  coverage.name = "coverage", coverage.value = 0.6;
  EXPECT_FALSE(run.partialCoverage());
  coverage.isMeaningful = true;
  EXPECT_EQ(run.partialCoverage(), 0.6);
  coverage.value = kNearlyAll;
  EXPECT_FALSE(run.partialCoverage());
}

TEST(Comparison, whatNobodyBearsOutCountsTwiceWhereAsMuchIsLacking) {
  EXPECT_EQ(unconfirmedFault(0.7, 0, 1), "") << "as a wing of its own may be";
  EXPECT_EQ(unconfirmedFault(0.98, 0, 0.5), "") << "as a part of the site is";
  EXPECT_EQ(unconfirmedFault(0.75, 0, 0.8),
            "has drawn 25 % that no other run confirms, and lacks 20 % of what others have: a part "
            "may lie in a wrong place");
  EXPECT_EQ(unconfirmedFault(0.699, 0, 1),
            "is confirmed by others in 69 % of what it has drawn, less than 70 %");
  EXPECT_EQ(unconfirmedFault(0.99, 0.002, 1),
            "has drawn 1 % that others contradict, and that fits nowhere else");
  ComparedRun run = runOf("a", 0.1);
  run.welded = {8, 201};
  EXPECT_EQ(run.unconfirmedFault(),
            "has drawn key frames 8 and 201 at one place, though they see through each other's "
            "walls");
  run.welded.reset();
  EXPECT_TRUE(run.isBorneOut());
  run.score->confirmed = 0.75;
  EXPECT_TRUE(run.isBorneOut());
  run.measures = {{"coverage", 0.8, "1", 500, {}, {}, true, {}}};
  EXPECT_FALSE(run.isBorneOut());
}

TEST(Comparison, aMapWithAPlaceThatNoOtherShowsIsNotBorneOut) {
  ComparedRun run = runOf("a", 0.1);
  run.measures = {{"walls_added", 0.6, "1", 5000, {}, {}, true, Point{1, 2}}};
  ASSERT_EQ(run.addedWalls(), &run.measures[0]);
  EXPECT_FALSE(run.isBorneOut());
  EXPECT_EQ(Comparison{}.certaintyOf(run), Certainty::doubtful);
  run.measures[0].isMeaningful = false;
  EXPECT_TRUE(run.isBorneOut()) << "nobody can tell";
  run.measures[0].isMeaningful = true, run.measures[0].value = kMostAdded;
  EXPECT_TRUE(run.isBorneOut()) << "as moved furniture is";
  run.measures[0].name = "straight_walls_added";
  EXPECT_FALSE(run.isBorneOut()) << "as it is not";
}

TEST(Comparison, copiesAndEditsAreSetsOfRuns) {
  using Sets = std::vector<std::vector<std::string>>;
  Comparison comparison;
  EXPECT_EQ(comparison.copies(), Sets{});
  comparison.pairs = {pairOf("a", "b", 1), pairOf("c", "d", 1), pairOf("b", "d", 1),
                      pairOf("e", "f", 1)};
  comparison.pairs[0].areCopies = comparison.pairs[1].areCopies = true;
  EXPECT_EQ(comparison.copies(), (Sets{{"a", "b"}, {"c", "d"}}));
  EXPECT_EQ(comparison.edits(), comparison.copies()) << "a copy is an edit, too";
  comparison.pairs[2].areEdits = true;
  EXPECT_EQ(comparison.edits(), (Sets{{"a", "b", "c", "d"}}));
}

}  // namespace
}  // namespace roomgraph
