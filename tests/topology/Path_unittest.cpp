#include "roomgraph/topology/Path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hand_built.h"

namespace roomgraph::test {
namespace {

TEST(Path, knowsLengthAndClearance) {
  const Path path = makePath({{0, 0}, {3, 4}, {3, 10}}, {{0, 1}, {5, 8}});
  EXPECT_DOUBLE_EQ(path.length, 11);
  EXPECT_NEAR(path.minClearance, 0.6, 1e-12);
}

TEST(Path, pieceKeepsWhatItCovers) {
  const Path path = straight({{0, 0}, {4, 0}, {4, 4}});
  const Path middle = piece(path, 1, 6);
  EXPECT_NEAR(distance(middle.points.front(), {1, 0}), 0, 1e-12);
  EXPECT_NEAR(distance(middle.points.back(), {4, 2}), 0, 1e-12);
  EXPECT_EQ(middle.points.size(), 3u);
  EXPECT_EQ(middle.obstacles.size(), 2u);
  EXPECT_EQ(piece(path, 0, path.length).points, path.points);
}

TEST(Path, aPlaceHasTheClearanceOfItsSegment) {
  const Path path = makePath({{0, 0}, {4, 0}, {8, 0}}, {{2, 1}, {6, 3}});
  EXPECT_DOUBLE_EQ(clearanceAt(path, 2), 1);
  EXPECT_DOUBLE_EQ(clearanceAt(path, 6), 3);
}

TEST(Path, aPieceWithoutLengthHasTheClearanceOfItsPlace) {
  const Path path = makePath({{0, 0}, {8, 0}}, {{0, 1}});
  for (const double along : {0.0, 3.0, path.length})
    EXPECT_NEAR(piece(path, along, along).minClearance, std::hypot(along, 1), 1e-12) << along;
}

TEST(Path, joinedWithItsReverseComesBack) {
  const Path path = straight({{0, 0}, {4, 0}, {4, 4}});
  const Path round = joined(path, reversed(path));
  EXPECT_DOUBLE_EQ(round.length, 16);
  EXPECT_EQ(round.points.front(), round.points.back());
  EXPECT_EQ(round.points.size(), 5u);
  EXPECT_EQ(round.obstacles.size(), 4u);
}

TEST(Path, placesBeyondItsEndsAreItsEnds) {
  const Path path = straight({{0, 0}, {4, 0}, {4, 4}});
  EXPECT_EQ(placeOn(path, -1), (Point{0, 0}));
  EXPECT_EQ(placeOn(path, 99), (Point{4, 4}));
  EXPECT_NEAR(distance(placeOn(path, 5), {4, 1}), 0, 1e-12);
}

TEST(Path, whatHasNoWayIsJoinedWithoutATrace) {
  const Path path = straight({{0, 0}, {4, 0}});
  Path place;
  place.points = {{4, 0}};
  EXPECT_EQ(joined(path, place).points, path.points);
  EXPECT_EQ(joined(place, path).points, path.points);
}

TEST(Path, backwardsItKeepsItsObstaclesBesideTheirSegments) {
  const Path path = makePath({{0, 0}, {4, 0}, {4, 9}}, {{1, 1}, {6, 5}});
  const Path back = reversed(path);
  EXPECT_EQ(back.obstacles.front(), (Point{6, 5}));
  EXPECT_DOUBLE_EQ(back.minClearance, path.minClearance);
  EXPECT_DOUBLE_EQ(back.length, path.length);
}

}  // namespace
}  // namespace roomgraph::test
