#include "roomgraph/align/verify_alignment.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/align/refine_alignment.h"

namespace roomgraph {
namespace {

const Transform2D kBFromA{2, 1, 0.6};

struct Pair {
  MapForAlignment a = mapForAlignment(test::drawnBuilding(5, {}), {});
  MapForAlignment b = mapForAlignment(test::drawnBuilding(5, kBFromA), {});
};

TEST(VerifyAlignment, theTruePoseIsNotContradicted) {
  const Pair pair;
  const AlignmentEvidence e = verifyAlignment(pair.a, pair.b, kBFromA.inverse(), {});
  EXPECT_GT(e.loose, 0.9 * e.all);
  EXPECT_LT(e.contradicted, 0.01 * e.all);
  EXPECT_GT(e.overlap, 0.95);
  EXPECT_LE(e.weakest, 0.5 * e.loose);
}

TEST(VerifyAlignment, aShiftedPoseIsContradicted) {
  const Pair pair;
  const Transform2D off = Transform2D{1.2, 0.9, 0} * kBFromA.inverse();
  const AlignmentEvidence right = verifyAlignment(pair.a, pair.b, kBFromA.inverse(), {});
  const AlignmentEvidence wrong = verifyAlignment(pair.a, pair.b, off, {});
  EXPECT_GT(wrong.contradicted, 0.2 * wrong.all);
  EXPECT_GT(wrong.freeOnWall, right.freeOnWall);
  EXPECT_GT(alignmentScore(right), alignmentScore(wrong));
  EXPECT_GT(sameSiteLogOdds(right), sameSiteLogOdds(wrong));
}

TEST(VerifyAlignment, mapsThatDoNotTouchSayNothing) {
  const Pair pair;
  const AlignmentEvidence e = verifyAlignment(pair.a, pair.b, {1000, 0, 0}, {});
  EXPECT_EQ(e.known, 0);
  EXPECT_EQ(e.loose, 0);
  EXPECT_EQ(e.contradicted, 0);
  EXPECT_EQ(e.overlap, 0);
}

TEST(RefineAlignment, pullsANearPoseIn) {
  const Pair pair;
  const Transform2D near = Transform2D{0.3, -0.25, 0.02} * kBFromA.inverse();
  const Transform2D found = refineAlignment(pair.a, pair.b, near, {});
  const Point middle = kBFromA({12, 8});
  EXPECT_LT(distance(found(middle), Point{12, 8}), 0.06);
  EXPECT_NEAR(wrappedAngle(found.phi + kBFromA.phi), 0, 0.005);
}

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

}  // namespace
}  // namespace roomgraph
