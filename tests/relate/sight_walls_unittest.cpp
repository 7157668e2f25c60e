#include "roomgraph/relate/sight_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

double shareOf(const std::vector<WallSighting>& seen, WallSighting what) {
  return double(std::count(seen.begin(), seen.end(), what)) / double(seen.size());
}

TEST(SightWalls, allIsFoundInABentMapAndNothingThereIsFree) {
  const Transform2D pose{3, -2, 0.8};
  const WallMap of = wallMap(test::drawnBuilding(1, {}));
  const WallMap in = wallMap(test::bent(test::drawnBuilding(1, pose), 0.05));
  const auto seen = sightWalls(of, in, followWalls(of, in, {pose}));
  EXPECT_GT(shareOf(seen, WallSighting::found), 0.9);
  EXPECT_LT(shareOf(seen, WallSighting::free), 0.02);
}

TEST(SightWalls, whatTheOtherHasNotSeenIsUnknown) {
  const WallMap of = wallMap(test::drawnBuilding(1, {}));
  const WallMap in = wallMap(test::drawnBuilding(1, {}, {-1e9, 12}));
  const auto seen = sightWalls(of, in, followWalls(of, in, {{}}));
  EXPECT_GT(shareOf(seen, WallSighting::unknown), 0.3);
  EXPECT_LT(shareOf(seen, WallSighting::free), 0.02);
  EXPECT_EQ(shareOf(sightWalls(of, in, {}), WallSighting::unknown), 1) << "nothing was followed";
}

TEST(SightWalls, aWallThatIsNeitherDrawnNorFreeIsFaded) {
  Grid blurred = test::drawnBuilding(1, {});
  const WallMap of = wallMap(blurred);
  for (std::size_t cell = 0; cell < blurred.cells.size(); ++cell)
    if (cell % std::size_t(blurred.frame.width) > 240 && blurred.cells[cell] == State::occupied)
      blurred.cells[cell] = State::unknown;
  const auto seen = sightWalls(of, wallMap(blurred), followWalls(of, wallMap(blurred), {{}}));
  EXPECT_GT(shareOf(seen, WallSighting::faded), 0.3);
  EXPECT_GT(shareOf(seen, WallSighting::found), 0.3);
}

TEST(StraightWalls, goOnForTwoMetres) {
  Grid grid;
  grid.frame = {200, 100, 0.05, {}};
  grid.cells.assign(grid.frame.cellCount(), State::free);
  for (int x = 20; x < 80; ++x) grid.cells[grid.frame.index({x, 30})] = State::occupied;
  for (int x = 120; x < 144; ++x) grid.cells[grid.frame.index({x, 30})] = State::occupied;
  const WallMap map = wallMap(grid);
  const std::vector<bool> straight = straightWalls(map);
  for (std::size_t i = 0; i < map.walls.size(); ++i) {
    const auto& [place, normal] = map.walls[i];
    if (std::abs(normal.y) < 0.99) continue;  // the ends
    EXPECT_EQ(straight[i], place.x < 5) << "3 m are, 1.2 m are not: " << place.x;
  }
}

}  // namespace
}  // namespace roomgraph
