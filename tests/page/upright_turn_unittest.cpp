#include "upright_turn.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

/** A map of walls that face these ways [rad]. */
WallMap facing(const std::vector<double>& ways) {
  WallMap map;
  for (const double way : ways) map.walls.push_back({{0, 0}, {std::cos(way), std::sin(way)}});
  return map;
}

TEST(UprightTurn, takesBackThePoseUpToQuarterTurns) {
  const WallMap map = facing({0, M_PI / 2, M_PI, -M_PI / 2, 0});
  for (const double turn : {0.3, -0.5, 0.7}) {
    EXPECT_NEAR(uprightTurn({&map, {3, 4, turn}}), -turn, 1e-9);
    EXPECT_NEAR(uprightTurn({&map, {0, 0, turn + M_PI / 2}}), -turn, 1e-9);
    EXPECT_NEAR(uprightTurn({&map, {0, 0, turn - M_PI}}), -turn, 1e-9);
  }
}

TEST(UprightTurn, fewSlantedWallsCountLittle) {
  const WallMap map = facing({0.2, 0.2 + M_PI / 2, 0.2, 0.2, 0.2, 0.2, 0.7});
  EXPECT_NEAR(uprightTurn({&map, {}}), -0.2, 0.1);
}

TEST(UprightTurn, whatStandsUprightStays) {
  const WallMap map = facing({0, M_PI / 2});
  EXPECT_EQ(uprightTurn({&map, {}}), 0);
  EXPECT_EQ(uprightTurn({&map, {1, 2, 0.01}}), 0) << "within a degree";
}

TEST(UprightTurn, withoutADirectionNothingIsTurned) {
  const WallMap round = facing({0.1, 0.1 + M_PI / 8, 0.1 + M_PI / 4, 0.1 - M_PI / 8});
  EXPECT_EQ(uprightTurn({&round, {}}), 0);
  const WallMap empty;
  EXPECT_EQ(uprightTurn({&empty, {0, 0, 0.3}}), 0);
  EXPECT_EQ(uprightTurn({nullptr, {0, 0, 0.3}}), 0);
}

}  // namespace
}  // namespace roomgraph
