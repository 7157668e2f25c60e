#include "roomgraph/check/find_revisits.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

std::vector<Revisit> revisits(const std::vector<Keyframe>& frames,
                              const std::vector<Transform2D>& poses) {
  return findRevisits(localScans(test::runOf(frames).scans), poses);
}

TEST(FindRevisits, aDriveForthAndBackFindsItselfWhereItWas) {
  const auto frames = test::driveForthAndBack();
  const auto poses = test::posesOf(frames);
  std::size_t found = 0;
  for (const Revisit& group : revisits(frames, poses))
    for (const PoseEdge& edge : group) {
      const Transform2D right = poses[edge.from.index()].inverse() * poses[edge.to.index()];
      EXPECT_LT(distance(edge.measured.shift(), right.shift()), 0.1);
      ++found;
    }
  EXPECT_GT(found, frames.size() / 2);
}

TEST(FindRevisits, aSlowDriftIsSeen) {
  const auto frames = test::driveForthAndBack();
  const auto right = test::posesOf(frames);
  auto poses = right;
  for (std::size_t k = 1; k < poses.size(); ++k)
    poses[k] = poses[k - 1] * (right[k - 1].inverse() * right[k] * Transform2D{0, 0.005, 0.001});
  std::size_t found = 0, good = 0;
  for (const Revisit& group : revisits(frames, poses))
    for (const PoseEdge& edge : group) {
      const Transform2D is = right[edge.from.index()].inverse() * right[edge.to.index()];
      ++found, good += distance(edge.measured.shift(), is.shift()) < 0.2;
    }
  EXPECT_GT(found, 20u);
  EXPECT_GE(good + found / 10, found);
}

TEST(FindRevisits, whatWasDrivenOnceHasNone) {
  const auto& once = test::driveOnce();
  const std::vector<Keyframe> half(once.begin(), once.begin() + 20);
  EXPECT_TRUE(revisits(half, test::posesOf(half)).empty());
  EXPECT_TRUE(findRevisits({}, {}).empty());
}

}  // namespace
}  // namespace roomgraph
