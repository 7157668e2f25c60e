#include "roomgraph/align/scan_axes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {
namespace {

constexpr int kBeams = 720;

/** A scan all around, of walls at `range` in each direction of the room. */
std::vector<Point> scanOf(const std::function<double(double)>& range, double heading) {
  std::vector<Point> ends;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = 2 * M_PI * i / kBeams;
    ends.push_back(range(angle + heading) * Point{std::cos(angle), std::sin(angle)});
  }
  return ends;
}

/** How far the walls of a rectangle are from a place inside of it. */
std::function<double(double)> rectangle(Point low, Point high) {
  return [=](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return std::min((c > 0 ? high.x : low.x) / c, (s > 0 ? high.y : low.y) / s);
  };
}

double modQuarterTurn(double angle) { return std::remainder(angle, M_PI / 2); }

TEST(ScanAxes, aRectangularRoomTellsItsTurn) {
  for (const double heading : {0.0, 0.2, -0.7, 1.3, 3.0}) {
    const auto axes = scanAxes(scanOf(rectangle({-2, -1.5}, {4, 2.5}), heading));
    ASSERT_TRUE(axes) << heading;
    EXPECT_NEAR(modQuarterTurn(axes->turn + heading), 0, 0.01) << heading;
    EXPECT_LE(std::abs(axes->turn), M_PI / 4 + 1e-9);
    EXPECT_GT(axes->weight, 0.9);
    EXPECT_LE(axes->weight, 1);
  }
}

TEST(ScanAxes, aRoundRoomHasNone) {
  for (const double radius : {1.0, 3.0, 8.0})
    EXPECT_FALSE(scanAxes(scanOf([&](double) { return radius; }, 0.3))) << radius;
}

TEST(ScanAxes, aSlantedRoomHasNone) {
  const auto square = rectangle({-3, -3}, {3, 3});
  const auto octagon = [&](double a) { return std::min(square(a), square(a + M_PI / 4)); };
  EXPECT_FALSE(scanAxes(scanOf(octagon, 0.1))) << "half of its walls lie across the other half";
}

TEST(ScanAxes, whatIsRoughIsNoWall) {
  const auto room = rectangle({-3, -3}, {3, 3});
  int beam = 0;
  const auto hedge = [&](double angle) { return room(angle) + (++beam % 2 ? 0.1 : -0.1); };
  EXPECT_FALSE(scanAxes(scanOf(hedge, 0)));
}

TEST(ScanAxes, aLongWallTellsMoreThanAShortOne) {
  const auto wall = [](double length) {
    std::vector<Point> ends;
    for (double x = 0; x <= length; x += 0.05) ends.push_back(Transform2D{2, 1, 0.4}({x, 0}));
    return scanAxes(ends);
  };
  EXPECT_FALSE(wall(0.8));
  ASSERT_TRUE(wall(1.5));
  ASSERT_TRUE(wall(3.2));
  ASSERT_TRUE(wall(8));
  EXPECT_NEAR(wall(3.2)->turn, 0.4, 1e-6);
  EXPECT_LT(wall(1.5)->weight, wall(3.2)->weight);
  EXPECT_LT(wall(3.2)->weight, wall(8)->weight);
}

TEST(ScanAxes, ofNothingThereAreNone) {
  EXPECT_FALSE(scanAxes({}));
  EXPECT_FALSE(scanAxes({{1, 1}}));
  EXPECT_FALSE(scanAxes(std::vector<Point>(500, Point{1, 1}))) << "all ends at one place";
}

}  // namespace
}  // namespace roomgraph
