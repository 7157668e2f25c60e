#include "belief.h"

#include <gtest/gtest.h>

#include "drawn_submaps.h"

namespace roomgraph {
namespace {

using test::roundTheBlock;
using test::Way;

/** Two runs, and one piece. */
struct TwoRuns {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3)};
  std::vector<RunMatches> matches{test::exactMatches(truth).front()};

  double belief(const PoseTolerance& within = kBorneOut) const {
    return beliefIn(matches, truth, within).front();
  }
};

TEST(Belief, isFullWhereThePosesBearAllOut) { EXPECT_EQ(TwoRuns().belief(), 1); }

TEST(Belief, fallsFasterThanTheShareThatIsBorneOut) {
  TwoRuns two;
  auto& matches = two.matches.front().matches;
  for (std::size_t m = 0; m < matches.size() / 2; ++m) matches[m].pose.x += 20;
  EXPECT_NEAR(two.belief(), 0.25, 0.02);
}

TEST(Belief, isNeverNothingSoThatAPieceCanComeBack) {
  TwoRuns two;
  for (SubmapMatch& match : two.matches.front().matches) match.pose.x += 20;
  EXPECT_GT(two.belief(), 0);
  EXPECT_LT(two.belief(), 0.01);
}

TEST(Belief, allowsMoreBeforeThePosesAreSolved) {
  TwoRuns two;
  for (SubmapMatch& match : two.matches.front().matches) match.pose.x += 2;
  EXPECT_LT(two.belief(kBorneOut), 0.01);
  EXPECT_EQ(two.belief(kRoughly), 1);
}

TEST(Belief, isFullOfWhatBothHaveScannedAsOne) {
  TwoRuns two;
  for (SubmapMatch& match : two.matches.front().matches)
    match.pose.x += 20, match.isSameScan = true;
  EXPECT_EQ(two.belief(), 1);
}

TEST(CostOfGivingUp, growsWithTheRootOfTheMatches) {
  RunMatches few, many;
  few.matches.resize(25), many.matches.resize(100);
  EXPECT_NEAR(costOfGivingUp(many), 2 * costOfGivingUp(few), 1e-9);
}

TEST(CostOfGivingUp, isLessWhereTheBuildingRepeatsItself) {
  RunMatches piece;
  piece.matches.resize(25);
  const double full = costOfGivingUp(piece);
  piece.likeness = 0.3;
  EXPECT_EQ(costOfGivingUp(piece), full) << "some likeness is everywhere";
  piece.likeness = 0.6;
  EXPECT_LT(costOfGivingUp(piece), 0.7 * full);
  piece.likeness = 1;
  EXPECT_GT(costOfGivingUp(piece), 0);
}

TEST(CostOfDisbelief, isThatOfWhatIsNotBelieved) {
  const TwoRuns two;
  const double full = costOfGivingUp(two.matches.front());
  EXPECT_EQ(costOfDisbelief(two.matches, {1}), 0);
  EXPECT_NEAR(costOfDisbelief(two.matches, {0.25}), 0.75 * full, 1e-9);
}

}  // namespace
}  // namespace roomgraph
