#include "navigation_word.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

Comparison bestWith(double error, double high) {
  Comparison comparison;
  comparison.runs.resize(2);
  comparison.runs[0].name = "best", comparison.runs[0].rank = 1;
  RunScore score;
  score.mapError = error, score.errorHigh = high, score.isMeaningful = true;
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
  EXPECT_TRUE(starts(navigationWord(bestWith(0.08, 0.15)),
                     "Navigation with best: good enough with a localisation that corrects itself; "
                     "probably also for docking"));
  EXPECT_TRUE(
      starts(navigationWord(bestWith(0.2, 0.4)),
             "Navigation with best: good enough with a localisation that corrects itself, and "
             "for lengths and areas; not for docking"));
  EXPECT_TRUE(starts(navigationWord(bestWith(0.5, 0.9)), "Navigation with best: perhaps"));
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

TEST(NavigationWord, doubtIsNeverGoodEnough) {
  Comparison comparison = bestWith(0, 0.02);
  comparison.pairs.resize(1);
  comparison.pairs[0].a = "best", comparison.pairs[0].isSameSite = true;
  comparison.pairs[0].confidence = 0.6;
  EXPECT_EQ(navigationWord(comparison),
            "Navigation with best: cannot be told, no pair that is sure joins it to most of the "
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
