#include "roomgraph/report/upright_turn.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

/** Walls of 5 m that face these ways [rad], each far from the others, as cells of 0.05 m have them:
 *  the normals of slanted ones lie off. */
std::vector<WallPoint> facing(const std::vector<double>& ways) {
  std::vector<WallPoint> walls;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const double steps = std::round(ways[i] / (M_PI / 4)) * (M_PI / 4);
    for (double along = 0; along < 5; along += 0.05)
      walls.push_back({{20.0 * double(i) - along * std::sin(ways[i]), along * std::cos(ways[i])},
                       {std::cos((ways[i] + steps) / 2), std::sin((ways[i] + steps) / 2)}});
  }
  return walls;
}

TEST(UprightTurn, takesBackThePoseUpToQuarterTurns) {
  const std::vector<WallPoint> walls = facing({0, M_PI / 2, M_PI, -M_PI / 2, 0});
  for (const double turn : {0.3, -0.5, 0.7}) {
    EXPECT_NEAR(uprightTurn(walls, turn), -turn, 1e-9);
    EXPECT_NEAR(uprightTurn(walls, turn + M_PI / 2), -turn, 1e-9);
    EXPECT_NEAR(uprightTurn(walls, turn - M_PI), -turn, 1e-9);
  }
}

TEST(UprightTurn, fewSlantedWallsCountLittle) {
  EXPECT_NEAR(uprightTurn(facing({0.2, 0.2 + M_PI / 2, 0.2, 0.2, 0.5, 0.7}), 0), -0.2, 1e-3);
}

TEST(UprightTurn, whatStandsUprightStays) {
  const std::vector<WallPoint> walls = facing({0, M_PI / 2});
  EXPECT_EQ(uprightTurn(walls, 0), 0);
  EXPECT_EQ(uprightTurn(walls, 0.01), 0) << "within a degree";
}

TEST(UprightTurn, withoutADirectionNothingIsTurned) {
  std::vector<double> all;
  for (int i = 0; i < 12; ++i) all.push_back(i * M_PI / 24);
  EXPECT_EQ(uprightTurn(facing(all), 0), 0);
  EXPECT_EQ(uprightTurn(std::vector<WallPoint>(), 0.3), 0);
}

TEST(UprightTurn, aSiteIsTurnedByItsFirstMap) {
  Comparison comparison;
  comparison.runs.resize(3);
  comparison.runs[0].name = "unread", comparison.runs[1].name = "first";
  comparison.runs[1].pose = {3, 4, 0.3}, comparison.runs[2].name = "second";
  std::vector<roomgraph::Run> runs(2);
  runs[0].name = "second", runs[1].name = "first";
  for (auto& run : runs) run.map.walls = facing({0, M_PI / 2});
  EXPECT_NEAR(uprightTurn(comparison, runs), -0.3, 1e-9);
  EXPECT_EQ(uprightTurn(comparison, {}), 0);
}

}  // namespace
}  // namespace roomgraph
