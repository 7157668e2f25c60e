#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "roomgraph/geometry/Polyline.h"
#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/grid/clear_clutter.h"
#include "roomgraph/grid/obstacle_sites.h"
#include "roomgraph/grid/thin_obstacles.h"

namespace roomgraph {
namespace {

/** Rows from top to bottom; '#' occupied, '.' free, '?' unknown. */
Grid gridFrom(const std::vector<std::string>& rows, double resolution = 0.1) {
  Grid grid;
  grid.frame = {int(rows.front().size()), int(rows.size()), resolution, {1, 2}};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char cell : *row)
      grid.cells.push_back(cell == '#'   ? State::occupied
                           : cell == '.' ? State::free
                                         : State::unknown);
  return grid;
}

GreyMap greyMapOf(std::vector<std::uint8_t> grey) {
  GreyMap map;
  map.frame = {int(grey.size()), 1, 0.1, {}};
  map.grey = std::move(grey);
  return map;
}

TEST(GridFrame, knowsTheCellOfAPlace) {
  const GridFrame frame{4, 3, 0.5, {10, -1}};
  EXPECT_EQ(frame.cellAt({10.6, -0.9}).x, 1);
  EXPECT_EQ(frame.cellAt({10.6, -0.9}).y, 0);
  EXPECT_EQ(frame.center({1, 2}), (Point{10.75, 0.25}));
  EXPECT_FALSE(frame.contains(frame.cellAt({9.99, 0})));
  EXPECT_FALSE(frame.contains(frame.cellAt({1e300, 0})));
  EXPECT_FALSE(frame.contains(frame.cellAt({-1e300, 0})));
  EXPECT_FALSE(frame.contains(frame.cellAt({std::numeric_limits<double>::quiet_NaN(), 0})));
}

TEST(Binarize, usesTheThresholdsOfTheFormat) {
  GreyMap map = greyMapOf({0, 80, 128, 180, 255});
  map.occupiedAbove = 0.65;
  map.freeBelow = 0.35;
  const std::vector<State> expected{State::occupied, State::occupied, State::unknown, State::free,
                                    State::free};
  EXPECT_EQ(binarize(map, {}).cells, expected);
}

TEST(Binarize, optionsOverrideTheFormat) {
  GreyMap map = greyMapOf({0, 80, 255});
  BinarizeOptions options;
  options.occupiedAbove = 0.9;
  options.freeBelow = 0.05;
  const std::vector<State> expected{State::occupied, State::unknown, State::free};
  EXPECT_EQ(binarize(map, options).cells, expected);
}

TEST(Binarize, thePapersThresholdKnowsTwoStates) {
  // The sum of three equal channels of 33 is 99, of 34 is 102.
  BinarizeOptions options;
  options.blackThreshold = 100;
  const std::vector<State> expected{State::occupied, State::occupied, State::free, State::free};
  EXPECT_EQ(binarize(greyMapOf({0, 33, 34, 128}), options).cells, expected);
}

std::size_t countKept(const std::vector<std::uint8_t>& flags) {
  return std::size_t(
      std::count_if(flags.begin(), flags.end(), [](auto flag) { return flag != 0; }));
}

TEST(ThinObstacles, dropsWhatBoundsNothing) {
  const Grid grid = gridFrom({".......", ".#####.", ".#####.", ".#####.", "......."});
  ThinObstaclesOptions options;
  options.neighbours = "none";
  EXPECT_EQ(countKept(thinObstacles(grid, options)), 15u);
  options.neighbours = "8";
  EXPECT_EQ(countKept(thinObstacles(grid, options)), 12u);
  options.neighbours = "4";
  EXPECT_EQ(countKept(thinObstacles(grid, options)), 12u);
}

TEST(ThinObstacles, fourNeighboursDropCornersThatEightKeep) {
  const Grid grid = gridFrom({"##.", "###", "###"});
  ThinObstaclesOptions options;
  options.neighbours = "8";
  const auto eight = thinObstacles(grid, options);
  EXPECT_TRUE(eight[grid.frame.index({1, 1})]);
  options.neighbours = "4";
  EXPECT_FALSE(thinObstacles(grid, options)[grid.frame.index({1, 1})]);
}

TEST(ThinObstacles, theBorderIsRepeatedOutwards) {
  const Grid grid = gridFrom({"##", "##"});
  EXPECT_EQ(countKept(thinObstacles(grid, {})), 0u);
}

TEST(ThinObstacles, unknownBoundsOnlyWhereAsked) {
  const Grid grid = gridFrom({".?.", ".?.", ".?."});
  ThinObstaclesOptions options;
  options.unknownIsObstacle = true;
  EXPECT_EQ(countKept(thinObstacles(grid, options)), 3u);
  options.unknownIsObstacle = false;
  EXPECT_EQ(countKept(thinObstacles(grid, options)), 0u);
}

TEST(ClearClutter, aLimitOfZeroKeepsEvenSingleCells) {
  const Grid grid = gridFrom({".....", ".....", "..#..", ".....", "....."});
  const ObstacleSites sites = obstacleSites(grid, thinObstacles(grid, {}), false);
  ASSERT_EQ(sites.cells.size(), 1u);
  ClearClutterOptions options;
  options.maxSize = 0;
  EXPECT_TRUE(clearClutter(grid, sites, options).clutter.empty());
  options.maxSize = 0.15;  // the diagonal of a cell is 0.141 m
  EXPECT_EQ(clearClutter(grid, sites, options).clutter.size(), 1u);
}

TEST(ObstacleSites, areOrderedByRowThenColumn) {
  const Grid grid = gridFrom({"#.#", "...", "##."});
  ThinObstaclesOptions all;
  all.neighbours = "none";
  for (const bool withRing : {false, true}) {
    const ObstacleSites sites = obstacleSites(grid, thinObstacles(grid, all), withRing);
    EXPECT_TRUE(std::is_sorted(sites.cells.begin(), sites.cells.end(), [](Cell a, Cell b) {
      return a.y < b.y || (a.y == b.y && a.x < b.x);
    }));
    EXPECT_EQ(sites.cells.size() > 4, withRing);
  }
}

TEST(ObstacleSites, theRingStandsBesideFreeCellsOnly) {
  const Grid grid = gridFrom({"#####", "#####", "####."});
  const auto none = std::vector<std::uint8_t>(grid.cells.size(), 0);
  const ObstacleSites sites = obstacleSites(grid, none, true);
  // Below, beside and diagonally round the free cell in the corner.
  EXPECT_EQ(sites.cells.size(), 5u);
  EXPECT_TRUE(obstacleSites(grid, none, false).cells.empty());
}

TEST(ObstacleRows, findTheNearestCellAsBruteForceDoes) {
  Grid grid = gridFrom(std::vector<std::string>(20, std::string(30, '.')), 0.1);
  std::uint32_t state = 7;
  const auto random = [&](std::uint32_t n) {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % n;
  };
  for (int i = 0; i < 25; ++i) grid.cells[random(600)] = State::occupied;
  ThinObstaclesOptions all;
  all.neighbours = "none";
  const ObstacleSites sites = obstacleSites(grid, thinObstacles(grid, all), true);
  const ObstacleRows rows(sites);
  for (int i = 0; i < 500; ++i) {
    const Point a{0.8 + 0.01 * random(350), 1.8 + 0.01 * random(250)};
    const Point b = i % 3 == 0 ? a : a + Point{0.01 * random(150) - 0.7, 0.01 * random(150) - 0.7};
    const double limit = 0.05 + 0.01 * random(100);
    double nearest = limit;
    for (const Cell cell : sites.cells)
      nearest = std::min(nearest, distanceToSegment(sites.frame.center(cell), a, b));
    EXPECT_DOUBLE_EQ(rows.clearance(a, b, limit), nearest) << i;
  }
}

TEST(ObstacleRows, withoutSitesGiveTheLimit) {
  const ObstacleSites sites{{5, 5, 0.1, {}}, {}};
  EXPECT_EQ(ObstacleRows(sites).clearance({0.1, 0.1}, {0.4, 0.3}, 2.5), 2.5);
}

}  // namespace
}  // namespace roomgraph
