#include "roomgraph/consensus/gait.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace roomgraph {
namespace {

/** Half a metre ahead each second, with a turn of so much each way in turns [rad]. */
std::vector<Transform2D> winding(double turn) {
  std::vector<Transform2D> poses(1);
  for (int k = 1; k < 40; ++k)
    poses.push_back(poses.back() * Transform2D{0.5, 0, k % 2 == 0 ? turn : -turn});
  return poses;
}

std::vector<std::optional<double>> eachSecond(std::size_t count, double pauseBefore20 = 0) {
  std::vector<std::optional<double>> times;
  for (std::size_t k = 0; k < count; ++k) times.push_back(double(k) + (k < 20 ? 0 : pauseBefore20));
  return times;
}

TEST(Gait, aStepIsNoLongerAndTurnsNoFurtherThanTheOthers) {
  const auto poses = winding(0.1);
  const Gait gait(poses, std::vector<std::optional<double>>(poses.size()));
  EXPECT_TRUE(gait.isPossible({0.6, 0, 0.2}, 20));
  EXPECT_FALSE(gait.isPossible({5, 0, 0}, 20));
  EXPECT_FALSE(gait.isPossible({0.5, 0, 2}, 20));
  EXPECT_FALSE(gait.isPossible({-2, 0, 0}, 20));
}

TEST(Gait, behindAPauseTheRobotMayHaveGoneOnAndTurned) {
  const auto poses = winding(0.1);
  const Gait gait(poses, eachSecond(poses.size(), 60));
  EXPECT_TRUE(gait.isPossible({20, -9, M_PI}, 20));
  EXPECT_FALSE(gait.isPossible({60, 0, 0}, 20)) << "but not so far";
  EXPECT_FALSE(gait.isPossible({0.5, 0, M_PI}, 21)) << "nor from then on";
}

TEST(Gait, whereTheClockWasSetBackAnyStepIsPossible) {
  const auto poses = winding(0.1);
  const Gait gait(poses, eachSecond(poses.size(), -30));
  EXPECT_TRUE(gait.isPossible({80, 3, 2}, 20));
  EXPECT_EQ(gait.reachTo(20), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace roomgraph
