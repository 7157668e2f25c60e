#include "wall_sightings.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/relate/place_runs.h"
#include "sampled_grid.h"

namespace roomgraph {
namespace {

using test::drawnBuilding;

/** A building, cell by cell as `cellOf` says. */
Grid edited(const std::function<State(const Grid&, Cell)>& cellOf) {
  const Grid grid = drawnBuilding(1, {2, 1, 0.3});
  return test::redrawn(grid, [&](Cell c) { return cellOf(grid, c); });
}

/** Runs of one building: the first one is as given, the second one is bent, two more are sound. */
struct Four {
  std::vector<roomgraph::Run> runs{4};
  MapPairs related{4};
  Site site;
  MapPairs pairs;
  Trust trust{1, 0.5, 1, 1};

  explicit Four(const Grid& first) {
    runs[0].map = wallMap(first);
    runs[1].map = wallMap(test::bent(drawnBuilding(1, {-3, 0, 2}), 0.03));
    runs[2].map = wallMap(drawnBuilding(1, {0.4, 0.7, -1}));
    runs[3].map = wallMap(drawnBuilding(1, {9, 9, 0.6}));
    for (const auto& [a, b] : related.pairs()) related(a, b) = relateMaps(runs[a].map, runs[b].map);
    site = placeRuns(runs, related, {});
    pairs = pairsInSite(site, related, oneByOne);
  }
  Four(const Four&) = delete;

  MeasuredValue measured(MeasuredValue (*figure)(const SightingTable&, const DistinctMaps&,
                                                 const Trust&, std::size_t),
                         std::size_t run = 0) const {
    return figure(wallSightings(site, pairs, oneByOne), DistinctMaps(bendsOf(pairs)), trust, run);
  }
};

const Four& sound() {
  static const Four four(drawnBuilding(1, {2, 1, 0.3}));
  return four;
}

TEST(WallSightings, aSoundMapLacksNoWallsAndABentOneDoesNotEither) {
  for (const std::size_t run : {0u, 1u, 2u}) {
    EXPECT_LT(*sound().measured(wallsMissingOf, run).value, 0.02) << run;
    EXPECT_LT(*sound().measured(wallsAddedOf, run).value, 0.02) << run;
    EXPECT_LT(*sound().measured(straightWallsAddedOf, run).value, 0.01) << run;
  }
  EXPECT_TRUE(sound().measured(wallsMissingOf).hasEnoughOthers);
  EXPECT_GT(sound().measured(wallsAddedOf).support, kFewestWalls);
}

/** The building with what is drawn instead of the walls in its middle. */
Grid withoutMiddle(State instead) {
  return edited([instead](const Grid& grid, Cell c) {
    const bool isMiddle =
        std::abs(c.x - grid.frame.width / 2) < 80 && std::abs(c.y - grid.frame.height / 2) < 60;
    const State state = grid.at(c);
    return isMiddle && state == State::occupied ? instead : state;
  });
}

TEST(WallSightings, wallsThatAreErasedAreMissing) {
  const Four blurred(withoutMiddle(State::unknown));
  EXPECT_GT(*blurred.measured(wallsMissingOf).value, 0.1) << "the floor ends, and no wall is there";
  EXPECT_LT(*blurred.measured(wallsAddedOf).value, 0.02);
  const Four four(withoutMiddle(State::free));
  EXPECT_GT(*four.measured(wallsMissingOf).value, 0.1);
  EXPECT_LT(*four.measured(wallsMissingOf, 2).value, 0.02) << "nobody else has lost any";
  EXPECT_LT(*four.measured(wallsAddedOf, 2).value, 0.02) << "two others have it, too";
}

TEST(WallSightings, wallsThatAreThinnedToDotsAreMissing) {
  const auto keep = [](unsigned ofTen) {
    std::mt19937 random(1);
    return Four(edited([&](const Grid& grid, Cell c) {
      const bool isGone = grid.at(c) == State::occupied && random() % 10 >= ofTen;
      return isGone ? State::free : grid.at(c);
    }));
  };
  const Four dots = keep(3), gaps = keep(8);
  EXPECT_GT(*dots.measured(wallsMissingOf).value, 0.5);
  EXPECT_LT(*dots.measured(wallsMissingOf, 2).value, 0.02) << "nobody else has lost any";
  EXPECT_LT(*gaps.measured(wallsMissingOf).value, 0.05) << "another lidar";
}

TEST(WallSightings, aMapOfLargeCellsHasFewerPointsOfTheSameWalls) {
  const Four& four = sound();
  SightingTable table = wallSightings(four.site, four.pairs, oneByOne);
  for (const std::size_t other : table.in.othersOf(0))
    for (std::size_t i = 0; i < table.in(0, other).size(); ++i)
      if (i % 3 != 0) table.in(0, other)[i] = WallSighting::unknown;
  const DistinctMaps maps(bendsOf(four.pairs));
  EXPECT_GT(*wallsMissingOf(table, maps, four.trust, 0).value, 0.5) << "dots";
  table.spacing[0] *= 3;
  EXPECT_LT(*wallsMissingOf(table, maps, four.trust, 0).value, 0.02);
}

TEST(WallSightings, specksAreAdded) {
  const Four four(edited([](const Grid& grid, Cell c) {
    const bool isSpeck = c.x % 12 == 0 && c.y % 12 == 0 && grid.at(c) == State::free;
    return isSpeck ? State::occupied : grid.at(c);
  }));
  EXPECT_GT(*four.measured(wallsAddedOf).value, 0.3);
  EXPECT_LT(*four.measured(straightWallsAddedOf).value, 0.02);
  EXPECT_LT(*four.measured(wallsMissingOf, 2).value, 0.02) << "no third one has them";
}

TEST(WallSightings, aRoomThatIsDrawnMirroredIsWrongThere) {
  const int side = 80;  // 8 m, about the middle of the map
  const Four four(edited([&](const Grid& grid, Cell c) {
    const Cell middle{grid.frame.width / 2, grid.frame.height / 2};
    const bool isInside = std::abs(c.x - middle.x) < side && std::abs(c.y - middle.y) < side;
    return grid.at(isInside ? Cell{2 * middle.x - c.x, c.y} : c);
  }));
  const MeasuredValue added = four.measured(wallsAddedOf);
  EXPECT_GT(*added.value, 0.3);
  EXPECT_GT(*four.measured(straightWallsAddedOf).value, 0.1);
  ASSERT_TRUE(added.place);
  const GridFrame& frame = four.runs[0].map.frame;
  EXPECT_LT(distance(*added.place, frame.center({frame.width / 2, frame.height / 2})), 6);
  EXPECT_LT(*four.measured(wallsAddedOf, 3).value, 0.05) << "two others have all that it has";
}

TEST(WallSightings, othersWithFarLessTrustThanARunWithScansAreNoWitnesses) {
  Four four(withoutMiddle(State::free));
  four.trust = {1, 1e-4, 1e-4, 1e-4};
  EXPECT_GT(*four.measured(wallsMissingOf).value, 0.1) << "without scans";
  four.runs[0].scans.resize(1);
  EXPECT_FALSE(four.measured(wallsMissingOf).value);
  EXPECT_FALSE(four.measured(wallsAddedOf).hasEnoughOthers);
  four.runs[2].scans.resize(1);
  EXPECT_TRUE(four.measured(wallsAddedOf, 2).hasEnoughOthers) << "they are no worse than itself";
}

TEST(WallSightings, copiesAreNoWitnesses) {
  Four four(drawnBuilding(1, {2, 1, 0.3}));
  for (const auto& [a, b] : {PairOfThings{1, 2}, {1, 3}, {2, 3}}) four.pairs(a, b).areEdits = true;
  EXPECT_FALSE(four.measured(wallsMissingOf).value) << "no wall is confirmed";
  EXPECT_FALSE(four.measured(wallsAddedOf).value);
}

}  // namespace
}  // namespace roomgraph
