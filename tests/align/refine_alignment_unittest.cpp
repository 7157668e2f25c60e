#include "roomgraph/align/refine_alignment.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

const Transform2D kBFromA{2, 1, 0.6};

struct Pair {
  WallMap a = wallMap(test::drawnBuilding(5, {}));
  WallMap b = wallMap(test::drawnBuilding(5, kBFromA));
};

TEST(RefineAlignment, pullsANearPoseIn) {
  const Pair pair;
  const Transform2D near = Transform2D{0.3, -0.25, 0.02} * kBFromA.inverse();
  const Transform2D found = refineAlignment(pair.a, pair.b, near);
  const Point middle = kBFromA({12, 8});
  EXPECT_LT(distance(found(middle), Point{12, 8}), 0.06);
  EXPECT_NEAR(wrappedAngle(found.phi + kBFromA.phi), 0, 0.005);
}

TEST(RefineAlignment, theTruePoseStaysWithinACell) {
  const Pair pair;
  const Transform2D found = refineAlignment(pair.a, pair.b, kBFromA.inverse());
  for (const Point p : {Point{2, 2}, {22, 2}, {12, 14}})
    EXPECT_LT(distance(found(kBFromA(p)), p), 0.06);
}

TEST(RefineAlignment, whatIsOutOfReachStaysAsItIs) {
  const Pair pair;
  const Transform2D far{500, 0, 0.3};
  const Transform2D found = refineAlignment(pair.a, pair.b, far);
  EXPECT_EQ(found.x, far.x);
  EXPECT_EQ(found.y, far.y);
  EXPECT_EQ(found.phi, far.phi);
}

TEST(RefineAlignment, swappingTheMapsGivesTheInverse) {
  const Pair pair;
  const Transform2D near = Transform2D{0.2, -0.15, 0.02} * kBFromA.inverse();
  const Transform2D forth = refineAlignment(pair.a, pair.b, near);
  const Transform2D back = refineAlignment(pair.b, pair.a, near.inverse()).inverse();
  for (const Point p : {Point{2, 2}, {22, 2}, {12, 14}})
    EXPECT_LT(distance(forth(kBFromA(p)), back(kBFromA(p))), 0.02);
}

TEST(RefineAlignment, whatIsRefinedStays) {
  const Pair pair;
  const Transform2D once = refineAlignment(pair.a, pair.b, kBFromA.inverse());
  const Transform2D twice = refineAlignment(pair.a, pair.b, once);
  for (const Point p : {Point{2, 2}, {22, 2}, {12, 14}})
    EXPECT_LT(distance(once(kBFromA(p)), twice(kBFromA(p))), 0.01);
}

TEST(RefineAlignment, withoutWallsThePoseStays) {
  const Pair pair;
  const WallMap empty = wallMap(Grid{});
  EXPECT_EQ(refineAlignment(pair.a, empty, {1, 2, 3}).x, 1);
  EXPECT_EQ(refineAlignment(empty, pair.a, {1, 2, 3}).phi, 3);
}

}  // namespace
}  // namespace roomgraph
