#include "belief.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "RandomNumbers.h"
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

TEST(IsBorneOut, theFrameOfTheSiteChangesNothing) {
  test::RandomNumbers random(4);
  std::size_t borneOut = 0;
  for (int i = 0; i < 200; ++i) {
    SubmapMatch match;
    match.pose = random.pose(3);
    const Transform2D in = random.pose(20), motion = random.pose(50);
    const Point off = random.place(1.2);
    const Transform2D of = in * match.pose * Transform2D{off.x, off.y, random.between(-0.2, 0.2)};
    const bool here = isBorneOut(match, in, of, kBorneOut);
    borneOut += here;
    EXPECT_EQ(isBorneOut(match, motion * in, motion * of, kBorneOut), here);
  }
  EXPECT_GT(borneOut, 20u);
  EXPECT_LT(borneOut, 180u) << "else this shows nothing";
}

TEST(BeliefOf, growsWithTheShareFromLittleToAll) {
  EXPECT_EQ(beliefOf(1), 1);
  double last = 0;
  for (int i = 0; i <= 10; ++i) {
    const double belief = beliefOf(i / 10.0);
    EXPECT_GT(belief, 0);
    EXPECT_GE(belief, last);
    EXPECT_LE(belief, std::max(1e-3, i / 10.0)) << "a part counts less than its share";
    last = belief;
  }
}

}  // namespace
}  // namespace roomgraph
