#include "roomgraph/align/verify_alignment.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "roomgraph/align/alignment_confidence.h"

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

}  // namespace
}  // namespace roomgraph
