#include "roomgraph/relate/site_poses.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "RandomNumbers.h"

namespace roomgraph {
namespace {

const std::vector<Transform2D> kTrue = {{0, 0, 0}, {3, 1, 0.5}, {-2, 4, 2}, {5, 5, -3}, {1, -6, 1}};

PairPoses pairsOfTrue(std::size_t runs, const std::vector<PairOfThings>& which) {
  PairPoses pairs(runs, which);
  for (const auto& [a, b] : which) pairs(a, b) = {kTrue[a].inverse() * kTrue[b], 0.95, {2, 3}};
  return pairs;
}

void expectTrue(const std::vector<Transform2D>& found, std::size_t run, double tolerance) {
  EXPECT_LT(distance(found[run].shift(), kTrue[run].shift()), tolerance) << run;
  EXPECT_NEAR(wrappedAngle(found[run].phi - kTrue[run].phi), 0, tolerance) << run;
}

/** How far the poses lay the middle of a pair from where it has it [m]. */
double misfit(const PairPoses& pairs, std::size_t a, std::size_t b,
              const std::vector<Transform2D>& poses) {
  const PairPose& pair = pairs(a, b);
  return distance(poses[b](pair.middle), poses[a](pair.pose(pair.middle)));
}

TEST(SitePoses, pairsThatAgreeGiveTheirPoses) {
  const auto found = sitePoses(pairsOfTrue(5, pairsOf(5)), 0);
  for (std::size_t run = 0; run < 5; ++run) expectTrue(found, run, 1e-9);
}

TEST(SitePoses, twoRunsHaveThePairsPose) {
  expectTrue(sitePoses(pairsOfTrue(2, {{0, 1}}), 0), 1, 1e-9);
}

TEST(SitePoses, oneWrongPairMovesNothing) {
  PairPoses pairs = pairsOfTrue(5, pairsOf(5));
  pairs(0, 2) = {Transform2D{20, -8, 1.2} * pairs(0, 2).pose, 1, {2, 3}};
  const auto found = sitePoses(pairs, 0);
  for (std::size_t run = 0; run < 5; ++run) expectTrue(found, run, 1e-3);
}

TEST(SitePoses, smallErrorsAreShared) {
  PairPoses pairs = pairsOfTrue(3, pairsOf(3));
  pairs(0, 2).pose.x += 0.3;
  const auto found = sitePoses(pairs, 0);
  for (const auto& [a, b] : pairs.pairs()) EXPECT_LT(misfit(pairs, a, b, found), 0.25);
}

/** Runs at random, and pairs that are a little off. */
PairPoses noisyPairs(std::uint32_t seed, std::size_t runs, std::size_t reach) {
  test::RandomNumbers random(seed);
  std::vector<Transform2D> truth;
  std::vector<PairOfThings> near;
  for (std::size_t i = 0; i < runs; ++i) truth.push_back(random.pose(20));
  for (const auto& [a, b] : pairsOf(runs))
    if (b - a <= reach) near.emplace_back(a, b);
  PairPoses pairs(runs, near);
  for (const auto& [a, b] : near) {
    const Transform2D off{random.between(-0.05, 0.05), random.between(-0.05, 0.05),
                          random.between(-0.005, 0.005)};
    pairs(a, b) = {truth[a].inverse() * truth[b] * off, random.between(0.5, 1), random.place(5)};
  }
  return pairs;
}

/** What the poses leave over of the pairs, with the weights of a robust fit. */
double costOf(const PairPoses& pairs, const std::vector<Transform2D>& poses) {
  double cost = 0;
  for (const auto& [a, b] : pairs.pairs()) {
    const PairPose& pair = pairs(a, b);
    const double off = misfit(pairs, a, b, poses);
    const double turn = kTurnLever * wrappedAngle(poses[b].phi - poses[a].phi - pair.pose.phi);
    const double s = (off * off + turn * turn) / (kMaxMisfit * kMaxMisfit);
    cost += pair.confidence * s / (1 + s);
  }
  return cost;
}

TEST(SitePoses, noRunCanMoveAloneAndFitBetter) {
  const PairPoses noisy = noisyPairs(1, 6, 6);
  const auto found = sitePoses(noisy, 0);
  const double best = costOf(noisy, found);
  for (std::size_t run = 1; run < 6; ++run)
    for (const Transform2D& nudge :
         {Transform2D{0.005, 0, 0}, Transform2D{0, -0.005, 0}, Transform2D{0, 0, 0.001}}) {
      std::vector<Transform2D> moved = found;
      moved[run] = moved[run] * nudge;
      EXPECT_GT(costOf(noisy, moved), best) << run;
    }
}

TEST(SitePoses, theReferenceChangesTheFrameOnly) {
  const PairPoses noisy = noisyPairs(4, 6, 6);
  const auto here = sitePoses(noisy, 0), there = sitePoses(noisy, 4);
  EXPECT_EQ(there[4].shift(), Point{});
  for (std::size_t run = 0; run < 6; ++run)
    EXPECT_LT(distance((here[4] * there[run]).shift(), here[run].shift()), 1e-5);
}

TEST(SitePoses, whatHangsOnAChainMovesNothingBeforeIt) {
  const PairPoses chain = noisyPairs(5, 59, 4);
  std::vector<PairOfThings> more = chain.pairs();
  more.insert(more.end(), {{58, 59}, {59, 60}});
  PairPoses longer(61, more);
  for (const auto& [a, b] : more)
    longer(a, b) = b < 59 ? chain(a, b) : PairPose{{1, 2, 0.3}, 0.9, {}};
  const auto before = sitePoses(chain, 0), after = sitePoses(longer, 0);
  for (std::size_t run = 0; run < 59; ++run)
    EXPECT_LT(distance(before[run].shift(), after[run].shift()), 1e-6) << run;
  EXPECT_NEAR(misfit(longer, 59, 60, after), 0, 1e-6);
}

TEST(SitePoses, whatClosesTrianglesIsTrustedMore) {
  // Of 0 and 3 there is one sure pair that is wrong; over 1 and 2 the right one comes out twice.
  PairPoses pairs = pairsOfTrue(4, pairsOf(4));
  for (const auto& [a, b] : pairs.pairs()) pairs(a, b).confidence = 0.7;
  pairs(0, 3) = {Transform2D{30, 0, 1} * pairs(0, 3).pose, 1, {2, 3}};
  expectTrue(sitePoses(pairs, 0), 3, 0.01);
}

TEST(SitePoses, aSiteOfOneRunLiesInItsOwnFrame) {
  const auto found = sitePoses(PairPoses(1), 0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].shift(), Point{});
}

}  // namespace
}  // namespace roomgraph
