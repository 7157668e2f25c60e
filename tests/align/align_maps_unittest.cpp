#include "roomgraph/align/align_maps.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

using test::drawnBuilding;
using test::squareHall;

WallMap prepared(const Grid& grid) { return wallMap(grid); }

/** Where the middle of the drawn buildings goes wrong, and the turn. */
void expectPose(const Transform2D& found, const Transform2D& expected, double metres) {
  EXPECT_NEAR(wrappedAngle(found.phi - expected.phi), 0, 0.01);
  const Point middle{expected.inverse()({12, 8})};
  EXPECT_LT(distance(found(middle), expected(middle)), metres);
}

TEST(AlignMaps, findsAKnownTurnAndShift) {
  const WallMap a = prepared(drawnBuilding(1, {}));
  for (const Transform2D& bFromA :
       {Transform2D{3, -40, 0.4}, Transform2D{-7, 2, 2.5}, Transform2D{0, 0, -1.9}}) {
    const WallMap b = prepared(drawnBuilding(1, bFromA));
    const Alignment found = alignMaps(a, b);
    expectPose(found.pose, bFromA.inverse(), 0.1);
    EXPECT_TRUE(found.isSameSite);
    EXPECT_GT(found.confidence, 0.9);
    EXPECT_GT(found.overlap, 0.95);
  }
}

TEST(AlignMaps, aMapFitsItselfAsItIs) {
  const WallMap a = prepared(drawnBuilding(2, {5, 6, 0.3}));
  const Alignment found = alignMaps(a, a);
  EXPECT_EQ(found.pose.x, 0);
  EXPECT_EQ(found.pose.y, 0);
  EXPECT_EQ(found.pose.phi, 0);
  EXPECT_TRUE(found.isSameSite);
  EXPECT_FALSE(found.isAmbiguous);
}

TEST(AlignMaps, swappingTheMapsInvertsThePose) {
  const WallMap a = prepared(drawnBuilding(3, {}));
  const WallMap b = prepared(drawnBuilding(3, {1, 2, 0.8}, {6, 1e9}));
  const Alignment forth = alignMaps(a, b), back = alignMaps(b, a);
  const Transform2D inverse = back.pose.inverse();
  EXPECT_NEAR(forth.pose.x, inverse.x, 1e-9);
  EXPECT_NEAR(forth.pose.y, inverse.y, 1e-9);
  EXPECT_NEAR(forth.pose.phi, inverse.phi, 1e-9);
  EXPECT_EQ(forth.confidence, back.confidence);
  EXPECT_EQ(forth.siteConfidence, back.siteConfidence);
  EXPECT_EQ(forth.overlap, back.overlap);
}

TEST(AlignMaps, findsMapsThatOverlapInPart) {
  const Transform2D bFromA{-3, 9, -2.2};
  const WallMap a = prepared(drawnBuilding(4, {}, {-1e9, 16}));
  const WallMap b = prepared(drawnBuilding(4, bFromA, {9, 1e9}));
  const Alignment found = alignMaps(a, b);
  expectPose(found.pose, bFromA.inverse(), 0.2);
  EXPECT_LT(found.overlap, 0.7);
}

TEST(AlignMaps, aSymmetricBuildingIsAmbiguous) {
  const WallMap a = prepared(squareHall({}));
  const WallMap b = prepared(squareHall({4, 1, 0.2}));
  const Alignment found = alignMaps(a, b);
  EXPECT_TRUE(found.isAmbiguous);
  EXPECT_LT(found.confidence, 0.7);
  ASSERT_TRUE(found.runnerUp);
  const double quarter = wrappedAngle(4 * (found.runnerUp->pose.phi - found.pose.phi));
  EXPECT_NEAR(quarter, 0, 0.1);
}

TEST(AlignMaps, differentBuildingsAreNotTheSameSite) {
  for (const std::uint32_t seed : {1u, 2u, 7u}) {
    const WallMap a = prepared(drawnBuilding(seed, {}));
    EXPECT_FALSE(alignMaps(a, prepared(drawnBuilding(seed + 10, {2, 3, 1}))).isSameSite);
  }
}

TEST(AlignMaps, aMapWithoutWallsHasNoPose) {
  const WallMap a = prepared(drawnBuilding(1, {}));
  Grid open = drawnBuilding(1, {});
  for (State& state : open.cells) state = State::free;
  for (const WallMap& none : {prepared(open), prepared(Grid{})}) {
    const Alignment found = alignMaps(a, none);
    EXPECT_FALSE(found.best);
    EXPECT_EQ(found.confidence, 0);
    EXPECT_FALSE(found.isSameSite);
    EXPECT_FALSE(alignMaps(none, none).isSameSite);
  }
}

}  // namespace
}  // namespace roomgraph
