#include "roomgraph/align/verify_alignment.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

const Transform2D kOffset{2, 1, 0.6};

struct VerifiedPair {
  WallMap a = wallMap(test::drawnBuilding(5, {}));
  WallMap b = wallMap(test::drawnBuilding(5, kOffset));
};

TEST(VerifyAlignment, theTruePoseIsNotContradicted) {
  const VerifiedPair pair;
  const AlignmentEvidence e = verifyAlignment(pair.a, pair.b, kOffset.inverse());
  EXPECT_GT(e.loose, 0.9 * e.all);
  EXPECT_LT(e.contradicted, 0.01 * e.all);
  EXPECT_GT(e.overlap, 0.95);
  EXPECT_LE(e.weakest, 0.5 * e.loose);
}

TEST(VerifyAlignment, aShiftedPoseIsContradicted) {
  const VerifiedPair pair;
  const Transform2D off = Transform2D{1.2, 0.9, 0} * kOffset.inverse();
  const AlignmentEvidence right = verifyAlignment(pair.a, pair.b, kOffset.inverse());
  const AlignmentEvidence wrong = verifyAlignment(pair.a, pair.b, off);
  EXPECT_GT(wrong.contradicted, 0.2 * wrong.all);
  EXPECT_GT(wrong.freeOnWall, right.freeOnWall);
  EXPECT_GT(alignmentScore(right), alignmentScore(wrong));
  EXPECT_GT(sameSiteLogOdds(right), sameSiteLogOdds(wrong));
}

TEST(VerifyAlignment, mapsThatDoNotTouchSayNothing) {
  const VerifiedPair pair;
  const AlignmentEvidence e = verifyAlignment(pair.a, pair.b, {1000, 0, 0});
  EXPECT_EQ(e.known, 0);
  EXPECT_EQ(e.loose, 0);
  EXPECT_EQ(e.contradicted, 0);
  EXPECT_EQ(e.overlap, 0);
}

void expectSame(const AlignmentEvidence& l, const AlignmentEvidence& r, double share) {
  const double little = share * l.all;
  EXPECT_NEAR(l.close, r.close, little);
  EXPECT_NEAR(l.loose, r.loose, little);
  EXPECT_NEAR(l.slightly, r.slightly, little);
  EXPECT_NEAR(l.contradicted, r.contradicted, little);
  EXPECT_NEAR(l.known, r.known, little);
  EXPECT_NEAR(l.all, r.all, little);
  EXPECT_NEAR(l.weakest, r.weakest, little);
  EXPECT_NEAR(l.overlap, r.overlap, share);
  EXPECT_NEAR(l.common, r.common, share * l.common + 1e-9);
  EXPECT_NEAR(l.freeOnWall, r.freeOnWall, share);
}

TEST(VerifyAlignment, swappingTheMapsChangesNothing) {
  const VerifiedPair pair;
  for (const Transform2D& pose : {kOffset.inverse(), Transform2D{3, 1, 0.4}, Transform2D{0, 4, -2}})
    expectSame(verifyAlignment(pair.a, pair.b, pose),
               verifyAlignment(pair.b, pair.a, pose.inverse()), 1e-9);
}

TEST(VerifyAlignment, theFramesOfTheMapsChangeLittle) {
  const VerifiedPair pair;
  const WallMap there = wallMap(test::drawnBuilding(5, {7, -3, 1.1}));
  const Transform2D off{0.4, -0.2, 0.02};
  expectSame(verifyAlignment(pair.a, pair.b, off * kOffset.inverse()),
             verifyAlignment(pair.a, there, off * Transform2D{7, -3, 1.1}.inverse()), 0.05);
}

TEST(VerifyAlignment, whatIsFoundAndContradictedIsPartOfWhatIsKnown) {
  const VerifiedPair pair;
  for (const Transform2D& pose :
       {kOffset.inverse(), Transform2D{3, 1, 0.4}, Transform2D{0, 4, -2}, Transform2D{9, 9, 3}}) {
    const AlignmentEvidence e = verifyAlignment(pair.a, pair.b, pose);
    EXPECT_LE(e.close, e.loose + 1e-9);
    EXPECT_LE(e.known, e.all + 1e-9);
    EXPECT_LE(e.loose, e.known + 1e-9);
    EXPECT_LE(e.contradicted, e.known + 1e-9);
    EXPECT_LE(e.weakest, e.loose / 2 + 1e-9);
    EXPECT_GE(e.weakest, -1e-9);
    EXPECT_GE(e.overlap, 0);
    EXPECT_LE(e.overlap, 1);
    EXPECT_LE(e.freeOnWall, 1);
  }
}

TEST(VerifyAlignment, wallsOfOneDirectionDoNotHoldAPose) {
  const VerifiedPair pair;
  WallMap striped = pair.a;
  for (WallPoint& wall : striped.walls) wall.normal = {wall.normal.x > 0 ? 1.0 : -1.0, 0};
  const AlignmentEvidence all = verifyAlignment(pair.a, pair.a, {});
  const AlignmentEvidence some = verifyAlignment(striped, striped, {});
  EXPECT_GT(all.weakest, 0.2 * all.loose);
  EXPECT_NEAR(some.weakest, 0, 1e-9);
}

TEST(VerifyAlignment, mapsWithoutWallsSayNothing) {
  const VerifiedPair pair;
  const AlignmentEvidence e = verifyAlignment(pair.a, wallMap(Grid{}), {});
  EXPECT_EQ(e.loose, 0);
  EXPECT_EQ(e.overlap, 0);
}

}  // namespace
}  // namespace roomgraph
