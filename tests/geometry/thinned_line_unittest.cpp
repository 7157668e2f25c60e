#include "roomgraph/geometry/thinned_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace roomgraph {
namespace {

TEST(ThinnedLine, dropsWhatLiesOnAStraightLine) {
  EXPECT_EQ(thinnedLine({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, 0.1), (Polyline{{0, 0}, {3, 0}}));
}

TEST(ThinnedLine, keepsCornersAndTurns) {
  EXPECT_EQ(thinnedLine({{0, 0}, {2, 0}, {2, 2}}, 0.1), (Polyline{{0, 0}, {2, 0}, {2, 2}}));
  EXPECT_EQ(thinnedLine({{0, 0}, {2, 0}, {1, 0}}, 0.1), (Polyline{{0, 0}, {2, 0}, {1, 0}}));
}

TEST(ThinnedLine, staysNearToAllPoints) {
  std::mt19937 random(7);
  std::normal_distribution<double> step(0, 0.3);
  Polyline line{{0, 0}};
  for (int i = 0; i < 2000; ++i)
    line.push_back(line.back() + Point{step(random) + 0.2, step(random)});
  const double tolerance = 0.4;
  const Polyline thin = thinnedLine(line, tolerance);
  EXPECT_LT(thin.size(), line.size() / 2);
  for (const Point p : line) {
    double nearest = 1e9;
    for (std::size_t i = 0; i + 1 < thin.size(); ++i)
      nearest = std::min(nearest, distanceToSegment(p, thin[i], thin[i + 1]));
    EXPECT_LE(nearest, 2 * tolerance);
  }
}

TEST(ThinnedLine, takesRepeatedPoints) {
  EXPECT_EQ(thinnedLine({{1, 1}, {1, 1}, {1, 1}}, 0.3), (Polyline{{1, 1}, {1, 1}}));
  EXPECT_TRUE(thinnedLine({}, 0.3).empty());
}

}  // namespace
}  // namespace roomgraph
