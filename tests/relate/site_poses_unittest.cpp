#include "roomgraph/relate/site_poses.h"

#include <gtest/gtest.h>

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
  const SitePoses found = sitePoses(5, allPairs(), 0, {});
  for (std::size_t run = 0; run < 5; ++run) expectTrue(found, run, 1e-9);
  for (const double misfit : found.misfit) EXPECT_NEAR(misfit, 0, 1e-9);
}

TEST(SitePoses, twoRunsHaveThePairsPose) {
  expectTrue(sitePoses(2, {pairOf(0, 1)}, 0, {}), 1, 1e-9);
}

TEST(SitePoses, thePairMayBeNamedTheOtherWayRound) {
  const PairPose pair{1, 0, kTrue[1].inverse() * kTrue[0], 0.9, {}};
  expectTrue(sitePoses(2, {pair}, 0, {}), 1, 1e-9);
}

TEST(SitePoses, oneWrongPairMovesNothing) {
  std::vector<PairPose> pairs = allPairs();
  pairs[1].pose = Transform2D{20, -8, 1.2} * pairs[1].pose;
  pairs[1].confidence = 1;
  const SitePoses found = sitePoses(5, pairs, 0, {});
  for (std::size_t run = 0; run < 5; ++run) expectTrue(found, run, 1e-3);
  EXPECT_GT(found.misfit[1], 5);
  EXPECT_LT(found.misfit[0], 0.01);
}

TEST(SitePoses, smallErrorsAreShared) {
  std::vector<PairPose> pairs = {pairOf(0, 1), pairOf(1, 2), pairOf(0, 2)};
  pairs[2].pose.x += 0.3;
  const SitePoses found = sitePoses(3, pairs, 0, {});
  for (const double misfit : found.misfit) EXPECT_LT(misfit, 0.25);
}

TEST(SitePoses, aRunWithoutATrustedPairIsNotPlaced) {
  std::vector<PairPose> pairs = {pairOf(0, 1), pairOf(1, 2)};
  pairs[1].confidence = 0.1;
  const SitePoses found = sitePoses(3, pairs, 0, {});
  EXPECT_TRUE(found.runs[1].isPlaced);
  EXPECT_FALSE(found.runs[2].isPlaced);
}

TEST(SitePoses, aStrangeRunIsAnError) {
  EXPECT_THROW(sitePoses(2, {pairOf(0, 2)}, 0, {}), UsageError);
  EXPECT_THROW(sitePoses(2, {}, 2, {}), UsageError);
}

}  // namespace
}  // namespace roomgraph
