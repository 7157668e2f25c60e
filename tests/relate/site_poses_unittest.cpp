#include "roomgraph/relate/site_poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "RandomNumbers.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

const std::vector<Transform2D> kTrue = {{0, 0, 0}, {3, 1, 0.5}, {-2, 4, 2}, {5, 5, -3}, {1, -6, 1}};

PairPose pairOf(std::size_t a, std::size_t b) {
  return {a, b, kTrue[a].inverse() * kTrue[b], 0.95, {2, 3}};
}

std::vector<PairPose> allPairs() {
  std::vector<PairPose> pairs;
  for (std::size_t a = 0; a < kTrue.size(); ++a)
    for (std::size_t b = a + 1; b < kTrue.size(); ++b) pairs.push_back(pairOf(a, b));
  return pairs;
}

void expectTrue(const SitePoses& found, std::size_t run, double tolerance) {
  EXPECT_TRUE(found.runs[run].isPlaced);
  EXPECT_NEAR(found.runs[run].pose.x, kTrue[run].x, tolerance);
  EXPECT_NEAR(found.runs[run].pose.y, kTrue[run].y, tolerance);
  EXPECT_NEAR(wrappedAngle(found.runs[run].pose.phi - kTrue[run].phi), 0, tolerance);
}

TEST(SitePoses, pairsThatAgreeGiveTheirPoses) {
  const SitePoses found = sitePoses(5, allPairs(), 0);
  for (std::size_t run = 0; run < 5; ++run) expectTrue(found, run, 1e-9);
  for (const double misfit : found.misfit) EXPECT_NEAR(misfit, 0, 1e-9);
}

TEST(SitePoses, twoRunsHaveThePairsPose) { expectTrue(sitePoses(2, {pairOf(0, 1)}, 0), 1, 1e-9); }

TEST(SitePoses, thePairMayBeNamedTheOtherWayRound) {
  const PairPose pair{1, 0, kTrue[1].inverse() * kTrue[0], 0.9, {}};
  expectTrue(sitePoses(2, {pair}, 0), 1, 1e-9);
}

TEST(SitePoses, oneWrongPairMovesNothing) {
  std::vector<PairPose> pairs = allPairs();
  pairs[1].pose = Transform2D{20, -8, 1.2} * pairs[1].pose;
  pairs[1].confidence = 1;
  const SitePoses found = sitePoses(5, pairs, 0);
  for (std::size_t run = 0; run < 5; ++run) expectTrue(found, run, 1e-3);
  EXPECT_GT(found.misfit[1], 5);
  EXPECT_LT(found.misfit[0], 0.01);
}

TEST(SitePoses, smallErrorsAreShared) {
  std::vector<PairPose> pairs = {pairOf(0, 1), pairOf(1, 2), pairOf(0, 2)};
  pairs[2].pose.x += 0.3;
  const SitePoses found = sitePoses(3, pairs, 0);
  for (const double misfit : found.misfit) EXPECT_LT(misfit, 0.25);
}

TEST(SitePoses, aRunWithoutATrustedPairIsNotPlaced) {
  std::vector<PairPose> pairs = {pairOf(0, 1), pairOf(1, 2)};
  pairs[1].confidence = 0.1;
  const SitePoses found = sitePoses(3, pairs, 0);
  EXPECT_TRUE(found.runs[1].isPlaced);
  EXPECT_FALSE(found.runs[2].isPlaced);
}

TEST(SitePoses, aStrangeRunIsAnError) {
  EXPECT_THROW(sitePoses(2, {pairOf(0, 2)}, 0), UsageError);
  EXPECT_THROW(sitePoses(2, {}, 2), UsageError);
}

/** Runs at random, and pairs that are a little off. */
struct NoisyPairs {
  std::vector<Transform2D> truth;
  std::vector<PairPose> pairs;

  NoisyPairs(std::uint32_t seed, std::size_t runs, std::size_t reach) {
    test::RandomNumbers random(seed);
    for (std::size_t i = 0; i < runs; ++i) truth.push_back(random.pose(20));
    for (std::size_t a = 0; a < runs; ++a)
      for (std::size_t b = a + 1; b < std::min(runs, a + 1 + reach); ++b) {
        const Transform2D off{random.between(-0.05, 0.05), random.between(-0.05, 0.05),
                              random.between(-0.005, 0.005)};
        pairs.push_back(
            {a, b, truth[a].inverse() * truth[b] * off, random.between(0.5, 1), random.place(5)});
      }
  }
};

/** What the poses leave over of the pairs, with the weights of a robust fit. */
double costOf(const std::vector<PairPose>& pairs, const std::vector<SitePose>& runs) {
  double cost = 0;
  for (const PairPose& pair : pairs) {
    const Transform2D &a = runs[pair.a].pose, &b = runs[pair.b].pose;
    const Point off = b(pair.middle) - a(pair.pose(pair.middle));
    const double turn = kTurnLever * wrappedAngle(b.phi - a.phi - pair.pose.phi);
    const double s = (squaredNorm(off) + turn * turn) / (kMaxMisfit * kMaxMisfit);
    cost += pair.confidence * s / (1 + s);
  }
  return cost;
}

TEST(SitePoses, noRunCanMoveAloneAndFitBetter) {
  const NoisyPairs noisy(1, 6, 6);
  const SitePoses found = sitePoses(6, noisy.pairs, 0);
  const double best = costOf(noisy.pairs, found.runs);
  for (std::size_t run = 1; run < 6; ++run)
    for (const Transform2D& nudge :
         {Transform2D{0.005, 0, 0}, Transform2D{0, -0.005, 0}, Transform2D{0, 0, 0.001}}) {
      std::vector<SitePose> moved = found.runs;
      moved[run].pose = moved[run].pose * nudge;
      EXPECT_GT(costOf(noisy.pairs, moved), best) << run;
    }
}

TEST(SitePoses, theOrderOfThePairsChangesNothing) {
  NoisyPairs noisy(2, 7, 7);
  const SitePoses before = sitePoses(7, noisy.pairs, 2);
  test::RandomNumbers random(3);
  random.shuffle(noisy.pairs);
  for (std::size_t i = 0; i < noisy.pairs.size(); i += 2) {
    PairPose& pair = noisy.pairs[i];  // named the other way round
    pair = {pair.b, pair.a, pair.pose.inverse(), pair.confidence, pair.pose(pair.middle)};
  }
  const SitePoses after = sitePoses(7, noisy.pairs, 2);
  for (std::size_t run = 0; run < 7; ++run)
    EXPECT_LT(distance(before.runs[run].pose.shift(), after.runs[run].pose.shift()), 1e-6);
}

TEST(SitePoses, theReferenceChangesTheFrameOnly) {
  const NoisyPairs noisy(4, 6, 6);
  const SitePoses here = sitePoses(6, noisy.pairs, 0), there = sitePoses(6, noisy.pairs, 4);
  const Transform2D motion = here.runs[4].pose;
  EXPECT_EQ(there.runs[4].pose.shift(), Point{});
  for (std::size_t run = 0; run < 6; ++run)
    EXPECT_LT(distance((motion * there.runs[run].pose).shift(), here.runs[run].pose.shift()), 1e-5);
  for (std::size_t i = 0; i < noisy.pairs.size(); ++i)
    EXPECT_NEAR(here.misfit[i], there.misfit[i], 1e-5);
}

TEST(SitePoses, ofManyRunsTheSparseEquationsSayTheSame) {
  // 59 runs are solved densely, 61 sparsely; the last two hang at the end of a chain, and so move
  // nothing of what is before them.
  NoisyPairs noisy(5, 59, 4);
  const SitePoses dense = sitePoses(59, noisy.pairs, 0);
  for (const std::size_t run : {59u, 60u})
    noisy.pairs.push_back({run - 1, run, {1, 2, 0.3}, 0.9, {}});
  const SitePoses sparse = sitePoses(61, noisy.pairs, 0);
  for (std::size_t run = 0; run < 59; ++run)
    EXPECT_LT(distance(dense.runs[run].pose.shift(), sparse.runs[run].pose.shift()), 1e-6) << run;
  EXPECT_TRUE(sparse.runs[60].isPlaced);
  EXPECT_NEAR(sparse.misfit.back(), 0, 1e-6);
}

TEST(SitePoses, whatClosesTrianglesIsTrustedMore) {
  // Of 0 and 3 there is one sure pair that is wrong; over 1 and 2 the right one comes out twice.
  std::vector<PairPose> pairs{pairOf(0, 1), pairOf(0, 2), pairOf(1, 2), pairOf(1, 3), pairOf(2, 3)};
  for (PairPose& pair : pairs) pair.confidence = 0.7;
  pairs.push_back(pairOf(0, 3));
  pairs.back().pose = Transform2D{30, 0, 1} * pairs.back().pose;
  pairs.back().confidence = 1;
  expectTrue(sitePoses(4, pairs, 0), 3, 0.01);
}

TEST(SitePoses, aSiteOfOneRunLiesInItsOwnFrame) {
  const SitePoses found = sitePoses(1, {}, 0);
  ASSERT_EQ(found.runs.size(), 1u);
  EXPECT_TRUE(found.runs[0].isPlaced);
  EXPECT_EQ(found.runs[0].pose.shift(), Point{});
  EXPECT_TRUE(found.misfit.empty());
}

TEST(SitePoses, aPairOfARunWithItselfIsAnError) {
  EXPECT_THROW(sitePoses(2, {{1, 1, {}, 0.9, {}}}, 0), UsageError);
}

}  // namespace
}  // namespace roomgraph
