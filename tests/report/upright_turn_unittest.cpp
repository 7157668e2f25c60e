#include "roomgraph/report/upright_turn.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

WallMap directed(std::optional<double> direction) {
  WallMap map;
  map.direction = direction;
  return map;
}

TEST(UprightTurn, takesBackThePoseUpToQuarterTurns) {
  for (const double turn : {0.3, -0.5, 0.7}) {
    EXPECT_NEAR(uprightTurn(directed(0), turn), -turn, 1e-9);
    EXPECT_NEAR(uprightTurn(directed(0), turn + M_PI / 2), -turn, 1e-9);
    EXPECT_NEAR(uprightTurn(directed(0), turn - M_PI), -turn, 1e-9);
    EXPECT_NEAR(uprightTurn(directed(turn), 0), -turn, 1e-9);
  }
}

TEST(UprightTurn, whatStandsUprightStays) {
  EXPECT_EQ(uprightTurn(directed(0), 0), 0);
  EXPECT_EQ(uprightTurn(directed(0), 0.01), 0) << "within a degree";
  EXPECT_EQ(uprightTurn(directed({}), 0.3), 0) << "without a direction";
}

TEST(UprightTurn, aSiteIsTurnedByItsFirstMap) {
  Comparison comparison;
  comparison.runs.resize(3);
  comparison.runs[0].name = "unread", comparison.runs[1].name = "first";
  comparison.runs[1].pose = {3, 4, 0.3}, comparison.runs[2].name = "second";
  std::vector<roomgraph::Run> runs(2);
  runs[0].name = "second", runs[1].name = "first";
  for (auto& run : runs) run.map = directed(0);
  EXPECT_NEAR(uprightTurn(comparison, runs), -0.3, 1e-9);
  EXPECT_EQ(uprightTurn(comparison, {}), 0);
}

}  // namespace
}  // namespace roomgraph
