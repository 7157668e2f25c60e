#include <gtest/gtest.h>

#include "RandomNumbers.h"
#include "edge_cost.h"

namespace roomgraph {
namespace {

constexpr double kRounding = 1e-9;

TEST(TurnedPose, followsOneAnotherAsTransformsDo) {
  test::RandomNumbers random(1);
  for (int i = 0; i < 50; ++i) {
    const Transform2D ab = random.pose(50), bc = random.pose(5);
    const Transform2D expected = ab * bc;
    const TurnedPose found = TurnedPose(ab) * TurnedPose(bc);
    EXPECT_NEAR(distance(found.shift, expected.shift()), 0, kRounding);
    EXPECT_NEAR(wrappedAngle(found.phi - expected.phi), 0, kRounding);
    EXPECT_NEAR(found.cos, std::cos(expected.phi), kRounding);
    EXPECT_NEAR(found.sin, std::sin(expected.phi), kRounding);
  }
}

TEST(TurnedPose, tellsHowFarAnEdgeIsOffAsTransformsDo) {
  test::RandomNumbers random(2);
  for (int i = 0; i < 50; ++i) {
    const PoseEdge edge = matchEdge(NodeId(0), NodeId(1), random.pose(5), 1);
    const Transform2D from = random.pose(50), to = random.pose(50);
    NodePoses poses;
    poses.add(from), poses.add(to);
    const PoseGap gap = TurnedPose(from).gapOf(edge, TurnedPose(to)), plain = gapOf(edge, poses);
    EXPECT_NEAR(gap.place, plain.place, kRounding);
    EXPECT_NEAR(gap.turn, plain.turn, kRounding);
  }
}

}  // namespace
}  // namespace roomgraph
