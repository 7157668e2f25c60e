#include "roomgraph/align/WallPatches.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

const std::vector<WallPoint>& buildingWalls() {
  static const std::vector<WallPoint> walls = wallMap(test::drawnBuilding(3, {1, 2, 0.3})).walls;
  return walls;
}

TEST(WallPatches, eachWallPointBelongsToOnePatch) {
  std::vector<int> count(buildingWalls().size());
  for (const WallPatch& patch : wallPatches(buildingWalls()))
    for (const std::uint32_t i : patch.own) ++count[i];
  EXPECT_EQ(std::count(count.begin(), count.end(), 1), long(count.size()));
}

TEST(WallPatches, whatIsAroundIsInReachAndNotTooMuch) {
  for (const WallPatch& patch : wallPatches(buildingWalls())) {
    EXPECT_LE(patch.around.size(), std::size_t(kMaxAround));
    EXPECT_FALSE(patch.around.empty());
    for (const std::uint32_t i : patch.around)
      EXPECT_LE(distance(buildingWalls()[i].place, patch.middle), 2 * kPatchSide);
  }
}

TEST(WallPatches, neighboursKnowEachOther) {
  const WallPatches patches = wallPatches(buildingWalls());
  for (std::uint32_t i = 0; i < patches.size(); ++i)
    for (const std::uint32_t j : patches[i].neighbours) {
      const auto& back = patches[j].neighbours;
      EXPECT_NE(i, j);
      EXPECT_TRUE(std::binary_search(back.begin(), back.end(), i));
    }
}

TEST(WallPatches, noWallsMakeNoPatches) { EXPECT_TRUE(wallPatches({}).empty()); }

}  // namespace
}  // namespace roomgraph
