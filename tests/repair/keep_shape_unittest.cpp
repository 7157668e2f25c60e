#include "keep_shape.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** Places every half metre along a line. */
std::vector<Transform2D> line(int count) {
  std::vector<Transform2D> places;
  for (int i = 0; i < count; ++i) places.push_back({0.5 * i, 0, 0});
  return places;
}

std::vector<Transform2D> moved(std::vector<Transform2D> places, double along) {
  for (Transform2D& place : places) place.y += along;
  return places;
}

TEST(KeepShape, onesThatJumpFollowTheirNeighbours) {
  const auto were = line(20), sound = moved(were, 3);
  auto poses = sound;
  poses[7].y += 2, poses[8].y += 2, poses[15].y -= 1;
  const auto hasMoved = keepShape(were, poses);
  for (std::size_t i = 0; i < were.size(); ++i) {
    EXPECT_NEAR(distance(poses[i].shift(), sound[i].shift()), 0, 1e-9) << i;
    EXPECT_EQ(hasMoved[i], i == 7 || i == 8 || i == 15) << i;
  }
}

TEST(KeepShape, aBreakAndABendStay) {
  const auto were = line(30);
  auto poses = were;
  for (std::size_t i = 0; i < 15; ++i) poses[i].y += 2;
  for (std::size_t i = 0; i < 30; ++i) poses[i].x += 0.01 * double(i);
  const auto before = poses;
  keepShape(were, poses);
  for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(poses[i].y, before[i].y) << i;
  for (const std::size_t few : {0u, 1u, 2u}) {
    auto none = line(int(few));
    EXPECT_EQ(keepShape(line(int(few)), none).size(), few);
  }
}

}  // namespace
}  // namespace roomgraph
