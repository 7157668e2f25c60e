#include "roomgraph/align/refine_alignment.h"

#include <gtest/gtest.h>

#include "drawn_building.h"

namespace roomgraph {
namespace {

const Transform2D kBFromA{2, 1, 0.6};

struct Pair {
  MapForAlignment a = mapForAlignment(test::drawnBuilding(5, {}), {});
  MapForAlignment b = mapForAlignment(test::drawnBuilding(5, kBFromA), {});
};

TEST(RefineAlignment, pullsANearPoseIn) {
  const Pair pair;
  const Transform2D near = Transform2D{0.3, -0.25, 0.02} * kBFromA.inverse();
  const Transform2D found = refineAlignment(pair.a, pair.b, near, {});
  const Point middle = kBFromA({12, 8});
  EXPECT_LT(distance(found(middle), Point{12, 8}), 0.06);
  EXPECT_NEAR(wrappedAngle(found.phi + kBFromA.phi), 0, 0.005);
}

TEST(RefineAlignment, theTruePoseStaysWithinACell) {
  const Pair pair;
  const Transform2D found = refineAlignment(pair.a, pair.b, kBFromA.inverse(), {});
  for (const Point p : {Point{2, 2}, {22, 2}, {12, 14}})
    EXPECT_LT(distance(found(kBFromA(p)), p), 0.06);
}

TEST(RefineAlignment, whatIsOutOfReachStaysAsItIs) {
  const Pair pair;
  const Transform2D far{500, 0, 0.3};
  const Transform2D found = refineAlignment(pair.a, pair.b, far, {});
  EXPECT_EQ(found.x, far.x);
  EXPECT_EQ(found.y, far.y);
  EXPECT_EQ(found.phi, far.phi);
}

}  // namespace
}  // namespace roomgraph
