#include "roomgraph/align/alignment_confidence.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(AlignmentConfidence, neverFallsWithTheMargin) {
  for (const double other : {-4.0, 0.0, 2.0, 6.0})
    for (double margin = 0; margin < 6; margin += 0.1)
      EXPECT_LE(poseConfidence(3, other, margin, 30), poseConfidence(3, other, margin + 0.1, 30));
}

TEST(AlignmentConfidence, anAmbiguousPoseIsNotTrusted) {
  EXPECT_TRUE(isAmbiguousPose(5, 0.1));
  EXPECT_LT(poseConfidence(6, 5, 0.1, 30), 0.7);
  EXPECT_FALSE(isAmbiguousPose(-3, 0.1));
  EXPECT_FALSE(isAmbiguousPose(5, 5));
}

TEST(AlignmentConfidence, aPoseThatSlidesAlongAHallIsNeverSure) {
  EXPECT_GT(poseConfidence(6, -4, 6, 10), 0.95);
  EXPECT_LT(poseConfidence(6, -4, 6, 2), 0.7);
}

/** What two good maps of one building have in common. */
AlignmentEvidence agreement() {
  AlignmentEvidence e;
  e.close = 80, e.loose = 95, e.slightly = 2, e.contradicted = 0.5;
  e.known = 100, e.all = 100, e.weakest = 40;
  e.overlap = 0.95, e.common = 150, e.freeOnWall = 0.01;
  return e;
}

TEST(AlignmentConfidence, wallsFoundAgainSpeakForAPose) {
  AlignmentEvidence fewer = agreement();
  fewer.close = 40, fewer.loose = 50;
  EXPECT_GT(alignmentScore(agreement()), alignmentScore(fewer));
  EXPECT_GT(sameSiteLogOdds(agreement()), sameSiteLogOdds(fewer));
}

TEST(AlignmentConfidence, contradictionSpeaksAgainstIt) {
  AlignmentEvidence torn = agreement();
  torn.contradicted = 30, torn.slightly = 40, torn.freeOnWall = 0.2;
  EXPECT_LT(alignmentScore(torn), alignmentScore(agreement()));
  EXPECT_LT(sameSiteLogOdds(torn), 0);
  EXPECT_GT(sameSiteLogOdds(agreement()), 2);
}

TEST(AlignmentConfidence, oddsStayWithinSix) {
  AlignmentEvidence certain = agreement();
  certain.loose = certain.close = certain.known = certain.all = certain.weakest = 1e6;
  EXPECT_LE(sameSiteLogOdds(certain), 6);
  AlignmentEvidence refuted = agreement();
  refuted.contradicted = refuted.slightly = refuted.known;
  EXPECT_GE(sameSiteLogOdds(refuted), -6);
}

TEST(AlignmentConfidence, probabilityIsLogistic) {
  EXPECT_EQ(probability(0), 0.5);
  EXPECT_DOUBLE_EQ(probability(2) + probability(-2), 1);
  EXPECT_GT(probability(3), 0.95);
}

}  // namespace
}  // namespace roomgraph
