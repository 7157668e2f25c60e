#include "roomgraph/grid/add_wall_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

/** A wall across free cells, with unknown cells below it. */
Grid wall(int width = 200, int height = 41) {
  Grid grid{{width, height, 0.1, {}}, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      grid.cells.push_back(y < height / 2    ? State::unknown
                           : y == height / 2 ? State::occupied
                                             : State::free);
  return grid;
}

auto occupied(const Grid& grid) {
  return std::count(grid.cells.begin(), grid.cells.end(), State::occupied);
}

/** Counts the cells that were `before` and are `after`. */
int changed(const Grid& a, const Grid& b, State before, State after) {
  int count = 0;
  for (std::size_t i = 0; i < a.cells.size(); ++i)
    count += a.cells[i] == before && b.cells[i] == after;
  return count;
}

TEST(AddWallNoise, movesTheGivenShareAndKeepsTheNumber) {
  const Grid grid = wall();
  const Grid noisy = addWallNoise(grid, {5, 10, 7});
  EXPECT_EQ(occupied(noisy), 200);
  const int freed = changed(grid, noisy, State::occupied, State::free);
  EXPECT_GT(freed, 10);  // some of the 20 are taken again
  EXPECT_LE(freed, 20);
  EXPECT_EQ(changed(grid, noisy, State::free, State::occupied) +
                changed(grid, noisy, State::unknown, State::occupied),
            freed);
}

TEST(AddWallNoise, reachesAsFarAsTheDistanceOnBothSidesOfAWallAndNoFarther) {
  const Grid grid = wall();
  for (const int distance : {1, 3, 5}) {
    const Grid noisy = addWallNoise(grid, {distance, 100, 1});
    int lowest = 0, highest = 0;
    for (int y = 0; y < grid.frame.height; ++y)
      for (int x = 0; x < grid.frame.width; ++x) {
        if (noisy.at({x, y}) != State::occupied) continue;
        lowest = std::min(lowest, y - grid.frame.height / 2);
        highest = std::max(highest, y - grid.frame.height / 2);
      }
    EXPECT_EQ(lowest, -distance);
    EXPECT_EQ(highest, distance);
  }
}

TEST(AddWallNoise, isTheSameForTheSameSeedOnly) {
  const Grid grid = wall();
  EXPECT_EQ(addWallNoise(grid, {3, 8, 42}).cells, addWallNoise(grid, {3, 8, 42}).cells);
  EXPECT_NE(addWallNoise(grid, {3, 8, 42}).cells, addWallNoise(grid, {3, 8, 43}).cells);
}

TEST(AddWallNoise, isTheSameOnEveryMachine) {
  const Grid grid = wall(12, 5);
  const Grid noisy = addWallNoise(grid, {1, 25, 1});
  std::string picture;
  for (const State state : noisy.cells)
    picture += state == State::occupied ? '#' : state == State::free ? '.' : '?';
  EXPECT_EQ(picture,
            "????????????"
            "?????#??????"
            "#..#####.###"
            ".....##....."
            "............");
}

TEST(AddWallNoise, leavesMapsAloneThatHaveNothingToMove) {
  const Grid grid = wall();
  EXPECT_EQ(addWallNoise(grid, {5, 0, 1}).cells, grid.cells);
  EXPECT_EQ(addWallNoise(grid, {0, 100, 1}).cells, grid.cells);  // each cell comes back
  const Grid empty{{3, 2, 0.1, {}}, std::vector<State>(6, State::free)};
  EXPECT_EQ(addWallNoise(empty, {5, 14, 1}).cells, empty.cells);
}

TEST(AddWallNoise, endsWhereAllCellsAreOccupied) {
  const Grid full{{30, 20, 0.1, {}}, std::vector<State>(600, State::occupied)};
  EXPECT_EQ(addWallNoise(full, {2, 14, 5}).cells, full.cells);
}

TEST(AddWallNoise, refusesWhatMakesNoSense) {
  EXPECT_THROW(addWallNoise(wall(), {5, 101, 1}), UsageError);
  EXPECT_THROW(addWallNoise(wall(), {5, -1, 1}), UsageError);
  EXPECT_THROW(addWallNoise(wall(), {-1, 5, 1}), UsageError);
}

}  // namespace
}  // namespace roomgraph
