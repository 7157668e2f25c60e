#include "straight_pieces.h"

#include <gtest/gtest.h>

#include <random>

namespace roomgraph {
namespace {

using Places = std::vector<std::size_t>;

Path pathOf(Polyline points, double minClearance) {
  Path path;
  path.length = length(points);
  path.points = std::move(points);
  path.minClearance = minClearance;
  return path;
}

const ObstacleCells kNothingInTheWay{{1, 1, 1, {}}, {}};

Places piecesOf(const Path& path) {
  return straightPieces(path, ObstacleRows(kNothingInTheWay), 0.01);
}

TEST(StraightPieces, aStraightWayIsOnePiece) {
  EXPECT_EQ(piecesOf(pathOf({{0, 0}, {1, 0.01}, {2, 0}, {3, 0}}, 0.5)), (Places{0, 3}));
}

TEST(StraightPieces, aCornerStays) {
  EXPECT_EQ(piecesOf(pathOf({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}}, 0.5)), (Places{0, 2, 4}));
}

TEST(StraightPieces, aNarrowWayKeepsItsBends) {
  const Polyline bent{{0, 0}, {1, 0.05}, {2, 0}};
  EXPECT_EQ(piecesOf(pathOf(bent, 0.5)), (Places{0, 2}));
  EXPECT_EQ(piecesOf(pathOf(bent, 0.08)), (Places{0, 1, 2}));
}

TEST(StraightPieces, aBendRoundAnObstacleStays) {
  const ObstacleCells post{{40, 40, 0.1, {-0.05, -2.05}}, {{10, 21}}};
  const Path path = pathOf({{0, 0}, {1, -0.05}, {2, 0}}, 0.15);
  EXPECT_EQ(straightPieces(path, ObstacleRows(post), 0.09), (Places{0, 2}));
  EXPECT_EQ(straightPieces(path, ObstacleRows(post), 0.12), (Places{0, 1, 2}));
}

TEST(StraightPieces, aLoopStaysALoop) {
  const Polyline loop{{0, 0}, {0.02, 0}, {0.04, 0.02}, {0.02, 0.04}, {0, 0.02}, {0, 0}};
  EXPECT_GE(piecesOf(pathOf(loop, 10)).size(), 4u);
}

TEST(StraightPieces, ofTheShortestPathsAreThePathsThemselves) {
  EXPECT_EQ(piecesOf(pathOf({}, 1)), Places{});
  EXPECT_EQ(piecesOf(pathOf({{1, 1}}, 1)), Places{0});
  EXPECT_EQ(piecesOf(pathOf({{1, 1}, {1, 1}}, 1)), (Places{0, 1}));
}

TEST(StraightPieces, noPointLiesFartherOffThanHalfOfTheClearance) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> step(-0.1, 0.1);
  for (int trial = 0; trial < 100; ++trial) {
    Polyline line{{0, 0}};
    for (int i = 0; i < 60; ++i)
      line.push_back(line.back() + Point{0.05 + step(random), step(random)});
    const double clearance = 0.02 + 0.005 * trial;
    const Places kept = piecesOf(pathOf(line, clearance));
    ASSERT_EQ(kept.front(), 0u);
    ASSERT_EQ(kept.back(), line.size() - 1);
    for (std::size_t k = 0; k + 1 < kept.size(); ++k)
      for (std::size_t i = kept[k]; i <= kept[k + 1]; ++i)
        EXPECT_LE(distanceToSegment(line[i], line[kept[k]], line[kept[k + 1]]),
                  std::min(0.1, clearance / 2) + 1e-12);
  }
}

}  // namespace
}  // namespace roomgraph
