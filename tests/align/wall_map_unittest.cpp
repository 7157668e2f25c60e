#include "roomgraph/align/wall_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_building.h"
#include "roomgraph/align/FullMaps.h"
#include "sampled_grid.h"

namespace roomgraph {
namespace {

TEST(WallMap, octantsAreNearestMultiplesOf45Degrees) {
  for (int degrees = -180; degrees < 540; degrees += 5) {
    const double angle = (degrees + 0.1) * M_PI / 180;
    const int expected = int(std::lround(angle / M_PI_4) + 16) % 8;
    EXPECT_EQ(octantOf({std::cos(angle), std::sin(angle)}), expected) << degrees;
  }
}

TEST(WallMap, wallsFaceTheFreeSpace) {
  const WallMap map = wallMap(test::squareHall({}));
  ASSERT_GT(map.walls.size(), 100u);
  for (const WallPoint& wall : map.walls) {
    const double far = std::max(std::abs(wall.place.x), std::abs(wall.place.y));
    const double outwards = dot(wall.place, wall.normal);
    EXPECT_TRUE(far > 3 ? outwards < 0 : outwards > 0) << wall.place.x << ", " << wall.place.y;
    EXPECT_NEAR(norm(wall.normal), 1, 1e-9);
  }
}

TEST(Coarser, keepsWallsAndWhatIsMostlyFree) {
  using S = State;
  const Grid grid{{5, 1, 1, {}}, {S::free, S::occupied, S::free, S::unknown, S::free}};
  EXPECT_EQ(coarser(grid, 2, 0).cells, (std::vector<State>{S::occupied, S::unknown, S::free}));
}

TEST(WallMap, measuresTheFreeSpace) {
  const WallMap map = wallMap(test::squareHall({}));
  EXPECT_NEAR(map.freeArea, 11.8 * 11.8 - 4, 4);
  const Cell beside = map.frame.cellAt({3.5, 0});
  EXPECT_NEAR(map.depths[map.frame.index(beside)], 2.4, 0.3);
}

TEST(WallMap, anEmptyMapHasNoWalls) {
  const WallMap map = wallMap(Grid{});
  EXPECT_TRUE(map.walls.empty());
  EXPECT_EQ(map.freeArea, 0);
}

TEST(WallMap, theNearestWallIsThatOfPlainSearch) {
  const WallMap map = wallMap(test::drawnBuilding(4, {1, 2, 0.3}));
  std::size_t found = 0;
  for (std::size_t i = 0; i < map.frame.cellCount(); i += 37)
    for (int octant = 0; octant < kOctants; ++octant) {
      const int width = map.frame.width;
      const Point at = map.frame.center({int(i) % width, int(i) / width});
      const Point axis{std::cos(octant * M_PI_4), std::sin(octant * M_PI_4)};
      double nearest = WallMap::kReach;
      for (const WallPoint& wall : map.walls)
        if (dot(wall.normal, axis) > M_SQRT1_2)
          nearest = std::min(nearest, distance(wall.place, at));
      const std::uint32_t wall = map.nearest[std::size_t(octant)][i];
      if (wall == kNoIndex) {
        EXPECT_GT(nearest, WallMap::kReach - 0.05) << i << ' ' << octant;
        continue;
      }
      ++found;
      EXPECT_GT(dot(map.walls[wall].normal, axis), M_SQRT1_2);
      EXPECT_LT(distance(map.walls[wall].place, at), nearest + map.frame.resolution)
          << "walls are spread cell by cell";
    }
  EXPECT_GT(found, 500u);
}

TEST(WallMap, depthsAreDistancesToWhatIsNotFree) {
  const WallMap map = wallMap(test::drawnBuilding(4, {}));
  std::size_t deep = 0;
  for (std::size_t i = 0; i < map.frame.cellCount(); i += 53) {
    const Cell cell{int(i) % map.frame.width, int(i) / map.frame.width};
    if (map.states[i] != State::free) {
      EXPECT_EQ(map.depths[i], 0);
      continue;
    }
    double nearest = HUGE_VAL;
    for (int y = 0; y < map.frame.height; ++y)
      for (int x = 0; x < map.frame.width; ++x)
        if (map.states[map.frame.index({x, y})] != State::free)
          nearest = std::min(nearest, std::hypot(x - cell.x, y - cell.y));
    nearest *= map.frame.resolution;
    EXPECT_GE(map.depths[i], nearest - 1e-4);
    EXPECT_LE(map.depths[i], 1.09 * nearest) << "steps along and across cells are longer";
    deep += map.depths[i] > 0.7;
  }
  EXPECT_GT(deep, 20u);
}

TEST(WallMap, aShiftOfTheFrameShiftsTheWalls) {
  Grid grid = test::drawnBuilding(6, {});
  const WallMap here = wallMap(grid);
  const Point shift{64, -32};
  grid.frame.origin = grid.frame.origin + shift;
  const WallMap there = wallMap(grid);
  // What lies on a boundary of cells falls to this side or the other by rounding.
  EXPECT_NEAR(double(here.walls.size()), double(there.walls.size()), 10);
  EXPECT_NEAR(here.freeArea, there.freeArea, 0.01 * here.freeArea);
  std::size_t alone = 0;
  for (const WallPoint& wall : here.walls)
    alone += std::none_of(there.walls.begin(), there.walls.end(), [&](const WallPoint& other) {
      return distance(wall.place + shift, other.place) < 0.03 &&
             distance(wall.normal, other.normal) < 0.1;
    });
  EXPECT_LT(alone, here.walls.size() / 50);
}

TEST(WallMap, unknownSpaceAroundAMapChangesNothing) {
  const Grid grid = test::drawnBuilding(6, {});
  Grid padded;
  const int pad = 24;
  padded.frame = grid.frame;
  padded.frame.width += 2 * pad, padded.frame.height += 2 * pad;
  padded.frame.origin = grid.frame.origin - grid.frame.resolution * Point{pad, pad};
  padded = test::redrawn(padded, [&](Cell c) { return grid.atOrUnknown({c.x - pad, c.y - pad}); });
  const WallMap here = wallMap(grid), there = wallMap(padded);
  ASSERT_EQ(here.walls.size(), there.walls.size());
  for (std::size_t i = 0; i < here.walls.size(); ++i)
    EXPECT_LT(distance(here.walls[i].place, there.walls[i].place), 1e-6);
  EXPECT_EQ(here.states, there.states);
}

TEST(WallMap, freeCellsAreSpreadOverTheFreeSpace) {
  const WallMap map = wallMap(test::drawnBuilding(4, {}));
  for (const std::uint32_t cell : map.freeCells) {
    EXPECT_EQ(map.states[cell], State::free);
    EXPECT_EQ(map.frame.index(map.frame.cellAt(map.placeOf(cell))), cell);
  }
  EXPECT_NEAR(double(map.freeCells.size()) * 0.2 * 0.2, map.freeArea, 0.1 * map.freeArea);
}

TEST(WallMap, thatWhichIsOnlyLookedForHasTheSameWalls) {
  const Grid grid = test::drawnBuilding(4, {});
  const WallMap whole = wallMap(grid), walls = bareWallMap(grid);
  ASSERT_EQ(walls.walls.size(), whole.walls.size());
  for (std::size_t i = 0; i < walls.walls.size(); ++i)
    EXPECT_EQ(walls.walls[i].place, whole.walls[i].place);
  EXPECT_EQ(walls.freeArea, whole.freeArea);
  EXPECT_FALSE(walls.axisDeviation);
  EXPECT_TRUE(whole.axisDeviation);
}

TEST(WallMap, aMapOfCoarserCellsKeepsThem) {
  Grid grid = test::drawnBuilding(4, {});
  EXPECT_EQ(wallMap(grid).frame.resolution, 0.1);
  grid.frame.resolution = 0.25;
  EXPECT_EQ(wallMap(grid).frame.resolution, 0.25);
}

TEST(WallMap, aMapWithoutFreeSpaceHasNoWalls) {
  Grid grid = test::squareHall({});
  for (State& state : grid.cells)
    if (state == State::free) state = State::unknown;
  const WallMap map = wallMap(grid);
  EXPECT_TRUE(map.walls.empty());
  EXPECT_EQ(map.freeArea, 0);
}

TEST(WallMap, aBareOneIsCompletedWithAllItHad) {
  const WallMap whole = wallMap(test::drawnBuilding(4, {}));
  EXPECT_FALSE(whole.isBare());
  WallMap bare = whole;
  dropLookUp(bare);
  EXPECT_TRUE(bare.isBare());
  FullMaps maps;
  const WallMap& full = maps(bare);
  EXPECT_EQ(&maps(bare), &full) << "once";
  EXPECT_EQ(&maps(whole), &whole) << "and only where it is needed";
  ASSERT_FALSE(full.isBare());
  for (std::size_t cell = 0; cell < whole.states.size(); ++cell) {
    ASSERT_EQ(full.depths[cell], whole.depths[cell]);
    for (std::size_t k = 0; k < kOctants; ++k)
      ASSERT_EQ(full.nearest[k][cell], whole.nearest[k][cell]);
  }
  EXPECT_FALSE(WallMap().isBare()) << "nothing is missing";
}

TEST(WallMap, severalAreCompletedAndKnownFromThenOn) {
  std::vector<WallMap> bare(2, wallMap(test::squareHall({})));
  for (WallMap& map : bare) dropLookUp(map);
  FullMaps maps;
  EXPECT_EQ(&maps.known(bare[0]), &bare[0]) << "nothing has been made";
  maps.complete({&bare[0], &bare[1], &bare[0]}, oneByOne);
  for (const WallMap& map : bare) {
    EXPECT_FALSE(maps.known(map).isBare());
    EXPECT_EQ(&maps(map), &maps.known(map));
  }
}

}  // namespace
}  // namespace roomgraph
