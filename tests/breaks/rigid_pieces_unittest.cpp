#include <gtest/gtest.h>

#include "drawn_building.h"
#include "drawn_graph.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/breaks/find_pieces.h"

namespace roomgraph {
namespace {

using test::everywhere;
using test::patchesOver;

std::size_t countPieces(const WallPatches& patches, const FollowedWalls& followed) {
  return rigidPieces(patches, followed).size();
}

TEST(RigidPieces, whatLiesAtOnePoseIsOnePiece) {
  const WallPatches patches = patchesOver({});
  EXPECT_EQ(countPieces(patches, everywhere(patches, {4, 5, 1})), 1u);
  EXPECT_EQ(countPieces(patches, {}), 0u);
}

TEST(RigidPieces, aJumpMakesTwo) {
  const WallPatches patches = patchesOver({});
  FollowedWalls jump = everywhere(patches, {});
  for (FollowedPatch& f : jump.patches)
    if (patches[f.patch].middle.x > 10) f.pose = carrying({10, 0}, {10, 0}, 0.12);
  EXPECT_EQ(countPieces(patches, jump), 2u);
  for (FollowedPatch& f : jump.patches)
    if (patches[f.patch].middle.x > 10) f.pose = {0, 0.7, 0};
  EXPECT_EQ(countPieces(patches, jump), 2u);
}

TEST(RigidPieces, thoseThatHoldTogetherAreToldLargestFirst) {
  const WallPatches patches = patchesOver({});
  FollowedWalls jump = everywhere(patches, {});
  for (FollowedPatch& f : jump.patches)
    if (patches[f.patch].middle.x < 6) f.pose = {0, 3, 0};
  const auto pieces = rigidPieces(patches, jump);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_GT(pieces[0].size(), pieces[1].size());
  EXPECT_EQ(pieces[0].size() + pieces[1].size(), jump.patches.size());
  for (const std::size_t k : pieces[1]) EXPECT_EQ(jump.patches[k].pose.y, 3);
}

TEST(RigidPieces, aBendIsNoBreak) {
  const WallPatches patches = patchesOver({});
  FollowedWalls bend = everywhere(patches, {});
  for (FollowedPatch& f : bend.patches)
    f.pose = carrying(patches[f.patch].middle, patches[f.patch].middle,
                      0.004 * patches[f.patch].middle.x);
  EXPECT_EQ(countPieces(patches, bend), 1u);
}

TEST(RigidPieces, aFewWallsElsewhereAreNoPiece) {
  const WallPatches patches = patchesOver({});
  FollowedWalls followed = everywhere(patches, {});
  followed.patches[0].pose = {3, 3, 0};
  EXPECT_EQ(countPieces(patches, followed), 1u);
}

TEST(RigidPieces, aBrokenBuildingHasTwo) {
  const Grid grid = test::drawnBuilding(1, {});
  const WallMap sound = wallMap(grid), broken = wallMap(test::bent(grid, 0.12));
  EXPECT_EQ(countPieces(sound.patches, followWalls(sound, sound, {{}})), 1u);
  const Transform2D other = carrying(sound.middle(), sound.middle(), -0.12);
  EXPECT_EQ(countPieces(broken.patches, followWalls(broken, sound, {{}, other})), 2u);
}

}  // namespace
}  // namespace roomgraph
