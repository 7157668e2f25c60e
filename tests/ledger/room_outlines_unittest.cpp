#include "room_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace roomgraph {
namespace {

/** A room like an L, so that it holds no turn but its own. */
Polygon ell() { return {{{0, 0}, {6, 0}, {6, 2}, {2.5, 2}, {2.5, 4}, {0, 4}}, {}}; }

Polygon moved(Polygon polygon, const Transform2D& by) {
  for (Point& p : polygon.outer) p = by(p);
  return polygon;
}

TEST(RoomOutline, hasPlacesAllAlongItWithNormalsAcross) {
  const RoomOutline outline(ell());
  EXPECT_NEAR(double(outline.places().size()), perimeter(ell()) / 0.1, 3);
  for (const Point& place : outline.places()) {
    EXPECT_EQ(sideOf(ell(), place), Side::onBoundary);
    EXPECT_NEAR(norm(outline.normal(&place)), 1, 1e-12);
    // The outer ring runs counter-clockwise: the room lies where the normals point.
    EXPECT_EQ(sideOf(ell(), place + 0.01 * outline.normal(&place)), Side::inside);
  }
}

TEST(RoomOutline, findsTheNearestPlaceWithinItsReach) {
  const RoomOutline outline(ell());
  const Point* nearest = outline.nearest({3.03, -0.4});
  ASSERT_TRUE(nearest);
  EXPECT_NEAR(distance(*nearest, {3.03, 0}), 0, 0.051);
  EXPECT_FALSE(outline.nearest({3, -0.6}));
  EXPECT_FALSE(RoomOutline(Polygon{}).nearest({0, 0}));
}

TEST(RefinedMove, anOutlineOnItselfStays) {
  const RoomOutline outline(ell());
  const RoomMove move = refinedMove(outline, outline, {}, {2, 2});
  EXPECT_EQ(move.shift, (Point{0, 0}));
  EXPECT_EQ(move.turn, 0);
}

TEST(RefinedMove, findsHowTheRoomWasDrawn) {
  const Point middle{2, 2};
  const RoomMove truth{{0.15, -0.1}, 0.03};
  const RoomOutline room(ell()), inRun(moved(ell(), truth.about(middle)));
  const RoomMove found = refinedMove(room, inRun, {}, middle);
  EXPECT_NEAR(found.shift.x, truth.shift.x, 0.01);
  EXPECT_NEAR(found.shift.y, truth.shift.y, 0.01);
  EXPECT_NEAR(found.turn, truth.turn, 0.005);
}

TEST(OutlineAgreement, isTheShareOfPlacesThatLieOnTheOther) {
  const RoomOutline outline(ell());
  EXPECT_EQ(outlineAgreement(outline, outline, {}, 0.1), 1);
  EXPECT_EQ(outlineAgreement(outline, outline, {100, 0, 0}, 0.1), 0);
  // Shifted along x, the walls along x still lie on each other: most of 12 of 20 m.
  EXPECT_NEAR(outlineAgreement(outline, outline, {0.3, 0, 0}, 0.1), 12.0 / 20, 0.05);
  EXPECT_EQ(outlineAgreement(RoomOutline(Polygon{}), RoomOutline(Polygon{}), {}, 0.1), 1);
}

TEST(OutlineAgreement, isThatOfTheRoomsInTheirFrames) {
  const Transform2D pose{3, -1, 2};
  const RoomOutline here(ell()), there(moved(ell(), pose));
  EXPECT_GT(outlineAgreement(here, there, pose, 0.06), 0.99);
}

TEST(Simplified, leavesOutCornersOnALine) {
  const Ring ring{{0, 0}, {1, 0.01}, {2, 0}, {4, 0}, {4, 3}, {2, 3.5}, {0, 3}};
  EXPECT_EQ(simplified(ring, 0.05), (Ring{{0, 0}, {4, 0}, {4, 3}, {2, 3.5}, {0, 3}}));
  EXPECT_EQ(simplified(ring, 0), ring);
  const Ring triangle{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(simplified(triangle, 10), triangle);
}

TEST(Simplified, dropsHolesThatVanish) {
  const Polygon polygon{
      {{0, 0}, {9, 0}, {9, 9}, {0, 9}},
      {{{1, 1}, {1, 1.01}, {1.02, 1.01}, {1.02, 1}}, {{4, 4}, {4, 6}, {6, 6}, {6, 4}}}};
  EXPECT_EQ(simplified(polygon, 0.05).holes.size(), 1u);
}

TEST(LengthOf, isFromEndToEnd) {
  EXPECT_NEAR(lengthOf({{{0, 0}, {12, 0}, {12, 2}, {0, 2}}, {}}), std::hypot(12, 2), 1e-12);
  EXPECT_EQ(lengthOf({}), 0);
}

TEST(RefinedMove, theFrameOfTheRunChangesNothing) {
  const Point middle{2, 2};
  const RoomMove truth{{0.12, 0.09}, -0.03};
  const Transform2D pose{40, -7, 1.4};
  const RoomOutline room(ell());
  const RoomMove here =
      refinedMove(room, RoomOutline(moved(ell(), truth.about(middle))), {}, middle);
  const RoomOutline there(moved(ell(), pose * truth.about(middle)));
  const RoomMove start{pose(middle) - middle, pose.phi};
  const RoomMove found = refinedMove(room, there, start, middle);
  EXPECT_NEAR(found.turn, pose.phi + here.turn, 0.004);
  EXPECT_LT(distance(middle + found.shift, pose(middle + here.shift)), 0.01);
}

TEST(RefinedMove, aWallThatOneHasMoreDoesNotPullTheRest) {
  const Point middle{2, 2};
  Polygon longer = ell();
  longer.outer[1].x = longer.outer[2].x = 6.4;  // one wall farther out
  const RoomMove found = refinedMove(RoomOutline(ell()), RoomOutline(longer), {}, middle);
  EXPECT_LT(norm(found.shift), 0.06);
  EXPECT_NEAR(found.turn, 0, 0.01);
}

TEST(OutlineAgreement, isTheSameFromBothSides) {
  const Transform2D pose{0.2, -0.15, 0.05};
  Polygon other = moved(ell(), pose);
  other.outer[3].y += 0.3;
  const RoomOutline a(ell()), b(other);
  for (const Transform2D& by : {Transform2D{}, pose})
    EXPECT_NEAR(outlineAgreement(a, b, by, 0.1), outlineAgreement(b, a, by.inverse(), 0.1), 0.02);
  EXPECT_GT(outlineAgreement(a, b, pose, 0.1), outlineAgreement(a, b, {}, 0.1));
}

TEST(Simplified, noCornerThatIsLeftOutIsFarFromTheRest) {
  Ring wavy;
  for (int k = 0; k < 200; ++k) {
    const double angle = 2 * M_PI * k / 200, far = 5 + 0.05 * std::sin(13 * angle);
    wavy.push_back({far * std::cos(angle), far * std::sin(angle)});
  }
  for (const double tolerance : {0.02, 0.1, 0.5}) {
    const Ring few = simplified(wavy, tolerance);
    EXPECT_LT(few.size(), wavy.size());
    for (const Point& p : wavy) {
      double nearest = HUGE_VAL;
      for (std::size_t k = 0; k < few.size(); ++k) {
        const Point a = few[k], along = few[(k + 1) % few.size()] - a;
        const double share = std::min(1.0, std::max(0.0, dot(p - a, along) / squaredNorm(along)));
        nearest = std::min(nearest, distance(p, a + share * along));
      }
      EXPECT_LE(nearest, tolerance + 1e-9);
    }
  }
}

TEST(LengthOf, doesNotChangeWithTheFrame) {
  EXPECT_NEAR(lengthOf(moved(ell(), {7, 3, 1.1})), lengthOf(ell()), 1e-9);
}

}  // namespace
}  // namespace roomgraph
