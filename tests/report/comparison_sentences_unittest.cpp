#include "roomgraph/report/comparison_sentences.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** Three runs, each aligned with each other for sure. */
Comparison threeRuns() {
  Comparison comparison;
  comparison.runs.resize(3);
  for (std::size_t i = 0; i < 3; ++i) comparison.runs[i].name = std::string(1, char('a' + i));
  for (const auto& [a, b] : {std::pair("a", "b"), std::pair("a", "c"), std::pair("b", "c")}) {
    comparison.pairs.emplace_back();
    comparison.pairs.back().a = a, comparison.pairs.back().b = b;
    comparison.pairs.back().isSameSite = true, comparison.pairs.back().confidence = 0.97;
  }
  return comparison;
}

MapBreak breakOf(const std::string& run, double rotation, double shift) {
  MapBreak one;
  one.run = run, one.rotation = rotation, one.shift = shift;
  return one;
}

TEST(ComparisonSentences, mapsThatBreakAreNamedByRank) {
  Comparison comparison = threeRuns();
  EXPECT_EQ(breaksSentence(comparison), "");
  comparison.breaks = {breakOf("b", 0.1, 1)};
  EXPECT_EQ(breaksSentence(comparison), "1 map breaks: b, by 5.7 degrees and 1.00 m.");
  comparison.breaks = {breakOf("b", -0.1, 3), breakOf("a", 0.1, 1), breakOf("b", 0.1, 0.5)};
  comparison.breaks[0].keyFrame = 47;
  EXPECT_EQ(breaksSentence(comparison),
            "2 maps break: a and b (2 places). The largest break: b from key frame 47 on, by 5.7 "
            "degrees and 3.00 m.");
}

TEST(ComparisonSentences, slightBreaksAreCountedApart) {
  Comparison comparison = threeRuns();
  comparison.breaks = {breakOf("b", 0.05, 0.1)};
  EXPECT_EQ(breaksSentence(comparison), "No map breaks; 1 slight break is listed.");
  comparison.breaks.insert(comparison.breaks.begin(), breakOf("a", 0.1, 1));
  comparison.breaks.push_back(breakOf("a", 0.04, 0.1));
  const std::string said = "1 map breaks: a, by 5.7 degrees and 1.00 m.";
  EXPECT_EQ(breaksSentence(comparison), said + " 2 slight breaks are listed, too.");
  // A turn may be slight, and yet move more than a break that is clear.
  std::swap(comparison.breaks[0], comparison.breaks[1]);
  EXPECT_EQ(breaksSentence(comparison), said + " 2 slight breaks are listed, too.");
}

TEST(ComparisonSentences, doubtIsAddedToABreak) {
  Comparison comparison = threeRuns();
  comparison.breaks = {breakOf("c", 0.1, 1)};
  comparison.pairs[1].confidence = comparison.pairs[2].confidence = 0.5;
  EXPECT_EQ(breaksSentence(comparison),
            "1 map breaks: c (position doubtful), by 5.7 degrees and 1.00 m.");
}

TEST(ComparisonSentences, unsurePairsAreNamedAndStayBelowTheLimit) {
  Comparison comparison = threeRuns();
  EXPECT_EQ(doubtSentence(comparison), "");
  comparison.pairs[1].confidence = 0.8999;
  EXPECT_EQ(doubtSentence(comparison),
            "1 pair was aligned with a confidence below 0.9: check a on c (0.89).");
  comparison.pairs[1].isSameSite = false;
  EXPECT_EQ(doubtSentence(comparison), "") << "of another site";
  comparison.pairs[1].isSameSite = true, comparison.pairs[1].b = "left out";
  EXPECT_EQ(doubtSentence(comparison), "") << "another site, compared by itself";
}

TEST(ComparisonSentences, aGateSaysByHowMuchItPassesOrWhyItFails) {
  EXPECT_EQ(gateSentence({}), "The gate passes.");
  EXPECT_EQ(gateSentence({{}, {"c"}, {"no break"}, {"c: has no break"}}),
            "The gate of c passes (no break): c: has no break.");
  EXPECT_EQ(gateSentence({{"c: breaks"}, {"c"}, {"no break"}, {}}),
            "The gate of c fails (no break): c: breaks.");
  EXPECT_EQ(gateLine({}), "PASS");
  EXPECT_EQ(gateLine({{}, {"c"}, {"no break"}, {"c: has no break"}}), "PASS c: has no break");
  EXPECT_EQ(gateLine({{}, {"c"}, {"no break"}, {}}), "PASS c");
  EXPECT_EQ(gateLine({{"c: breaks"}, {"c"}, {"no break"}, {}}), "FAIL c: breaks");
  EXPECT_EQ(gateLine({{"c: breaks, twice", "c: is bad", "d: breaks"}, {}, {}, {}}),
            "FAIL c: breaks, twice; is bad; and d: breaks");
  EXPECT_EQ(gateLine({{"c: 1", "c: 2", "c: 3", "c: 4", "c: 5", "c: 6", "c: 7"}, {}, {}, {}}),
            "FAIL c: 1; 2; 3; 4; and 3 more");
  EXPECT_EQ(gateLine({{"c: 1", "c: 2", "c: 3", "c: 4", "c: 5"}, {}, {}, {}}),
            "FAIL c: 1; 2; 3; 4; and 5");
}

}  // namespace
}  // namespace roomgraph
