#include "roomgraph/align/wall_share.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

WallShare shareAt(const WallMap& map, const Transform2D& pose, double near = kWallNoise,
                  std::size_t stride = 1) {
  const auto pointAt = [&](std::size_t i) -> const WallPoint& { return map.walls[i]; };
  return wallShare(map.walls.size(), pointAt, map, pose, near, stride);
}

TEST(WallShare, allWallsOfAMapAreFoundInItself) {
  const WallMap map = wallMap(test::drawnBuilding(5, {}));
  const WallShare share = shareAt(map, {});
  EXPECT_EQ(share.all, double(map.walls.size()));
  EXPECT_EQ(share.known, share.all);
  EXPECT_GT(share.ofKnown(), 0.95);
  EXPECT_LT(share.ofKnown(share.known), 0.5) << "as many that speak against it";
}

TEST(WallShare, aWallCountsHalfAtItsNoise) {
  const WallMap map = wallMap(test::squareHall({}));
  const auto sunk = [&](double near) { return shareAt(map, {0.2, 0.2, 0}, near).ofKnown(); };
  EXPECT_GT(sunk(0.4), sunk(0.2));
  EXPECT_GT(sunk(0.2), sunk(0.05));
}

TEST(WallShare, whatNobodyHasSeenIsNotKnown) {
  const WallMap map = wallMap(test::drawnBuilding(5, {}));
  const WallShare share = shareAt(map, {1000, 0, 0});
  EXPECT_GT(share.all, 0);
  EXPECT_EQ(share.known, 0);
  EXPECT_EQ(share.ofKnown(), 0);
}

TEST(WallShare, aStrideLooksAtThatManyFewer) {
  const WallMap map = wallMap(test::drawnBuilding(5, {}));
  EXPECT_NEAR(3 * shareAt(map, {}, kWallNoise, 3).all, shareAt(map, {}).all, 3);
}

}  // namespace
}  // namespace roomgraph
