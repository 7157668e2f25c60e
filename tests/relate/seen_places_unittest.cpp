#include "seen_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

std::size_t sharedOf(const SeenPlaces& l, const SeenPlaces& r) {
  SeenPlaces both;
  std::set_intersection(l.begin(), l.end(), r.begin(), r.end(), std::back_inserter(both));
  return both.size();
}

TEST(SeenPlaces, twoMapsOfOneBuildingHaveTheSameOnesInOneFrame) {
  const Transform2D there{-7, 2, 2.5};
  const auto l = seenPlaces(wallMap(test::drawnBuilding(1, {})), {});
  const auto r = seenPlaces(wallMap(test::drawnBuilding(1, there)), there.inverse());
  EXPECT_TRUE(std::is_sorted(l.begin(), l.end()));
  EXPECT_EQ(std::adjacent_find(l.begin(), l.end()), l.end());
  EXPECT_GT(l.size(), 200u) << "a building of 22 m by 15 m";
  EXPECT_LT(l.size(), 420u);
  EXPECT_GT(double(sharedOf(l, r)), 0.9 * double(l.size()));
  const auto apart = seenPlaces(wallMap(test::drawnBuilding(1, there)), {});
  EXPECT_LT(double(sharedOf(l, apart)), 0.5 * double(l.size()));
}

TEST(SeenPlaces, squaresThatAreFarApartAreNotTheSame) {
  WallMap map;
  map.frame = {4, 4, 1, {-2, -2}};
  map.freeCells = {6, 9, 10};  // round the origin
  EXPECT_EQ(seenPlaces(map, {}).size(), 3u);
  const SeenPlaces right = seenPlaces(map, {1e30, 0, 0}), left = seenPlaces(map, {-1e30, 0, 0});
  EXPECT_EQ(right.size(), 2u) << "as far as a number goes, two of them are one";
  EXPECT_EQ(sharedOf(left, right), 0u);
  EXPECT_TRUE(seenPlaces(WallMap(), {}).empty());
}

}  // namespace
}  // namespace roomgraph
