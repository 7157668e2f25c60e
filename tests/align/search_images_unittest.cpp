#include "search_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

constexpr double kCell = 0.25;

const WallMap& building() {
  static const WallMap the = wallMap(test::drawnBuilding(5, {}));
  return the;
}

int valueAt(const SearchImages& images, int octant, Cell cell) {
  const int x = cell.x - images.low.x, y = cell.y - images.low.y;
  if (x < 0 || y < 0 || x >= images.width || y >= images.height) return 0;
  return images.values[std::size_t(octant)][images.index(x, y)];
}

using Place = std::tuple<int, int, int>;

std::multiset<Place> placesOf(const std::vector<SearchPoint>& points) {
  std::multiset<Place> places;
  for (const SearchPoint& point : points) places.insert({point.cell.x, point.cell.y, point.octant});
  return places;
}

TEST(SearchImages, theMiddleOfTheMapIsTheOrigin) {
  const CentredMap map = centred(building());
  ASSERT_EQ(map.walls.size(), building().walls.size());
  const Point middle = building().middle();
  for (std::size_t i = 0; i < map.walls.size(); ++i) {
    EXPECT_LT(distance(map.walls[i].place + middle, building().walls[i].place), 1e-9);
    EXPECT_EQ(map.walls[i].normal, building().walls[i].normal);
  }
  ASSERT_EQ(map.freePlaces.size(), building().freeCells.size());
  const auto deep = std::count_if(map.freePlaces.begin(), map.freePlaces.end(),
                                  [](const CentredMap::FreePlace& p) { return p.isDeep; });
  EXPECT_GT(deep, 0);
  EXPECT_LT(std::size_t(deep), map.freePlaces.size()) << "not what is beside a wall";
}

TEST(SearchImages, ofManyPointsAnEvenChoiceIsTaken) {
  const CentredMap map = centred(building());
  const std::size_t all = map.walls.size();
  EXPECT_EQ(searchPoints(map, 0, kCell, all, 1).size(), all);
  EXPECT_EQ(searchPoints(map, 0, kCell, 10 * all, 1).size(), all);
  for (const std::size_t most : {1u, 7u, 100u, 500u}) {
    const std::size_t taken = searchPoints(map, 0, kCell, most, 1).size();
    EXPECT_LE(taken, most);
    EXPECT_GE(2 * taken, std::min(most, all)) << "not far fewer";
  }
}

TEST(SearchImages, fourQuarterTurnsAreNone) {
  const CentredMap map = centred(building());
  const auto none = searchPoints(map, 0, kCell, map.walls.size(), 1);
  const auto quarter = searchPoints(map, M_PI / 2, kCell, map.walls.size(), 1);
  ASSERT_EQ(none.size(), quarter.size());
  for (std::size_t i = 0; i < none.size(); ++i)
    EXPECT_EQ(quarter[i].octant, (none[i].octant + 2) % kOctants);
  // A place on a boundary of cells falls to this side or the other by rounding.
  std::size_t moved = 0;
  for (std::size_t i = 0; i < none.size(); ++i)
    moved += quarter[i].cell.x != -none[i].cell.y - 1 || quarter[i].cell.y != none[i].cell.x;
  EXPECT_LT(moved, none.size() / 10);
}

TEST(SearchImages, mirroredPointsAndImagesAreThoseOfTheOppositeCells) {
  const CentredMap map = centred(building());
  const auto plain = searchPoints(map, 0.7, kCell, map.walls.size(), 1);
  const auto mirrored = searchPoints(map, 0.7, kCell, map.walls.size(), -1);
  std::multiset<Place> expected;
  for (const SearchPoint& p : plain) expected.insert({-p.cell.x, -p.cell.y, p.octant});
  EXPECT_EQ(placesOf(mirrored), expected);
  const SearchImages here = imagesOf(map, 0.7, kCell, 1), there = imagesOf(map, 0.7, kCell, -1);
  for (int octant = 0; octant < kOctants; ++octant)
    for (int y = -40; y <= 40; y += 3)
      for (int x = -60; x <= 60; x += 3)
        EXPECT_EQ(valueAt(here, octant, {x, y}), valueAt(there, octant, {-x, -y}));
}

TEST(SearchImages, aWallIsWorthMostInItsOwnCellAndToWhatFacesItsWay) {
  const CentredMap map = centred(building());
  const SearchImages images = imagesOf(map, 0, kCell, 1);
  int most = 0;
  for (const auto& values : images.values)
    most = std::max(most, int(*std::max_element(values.begin(), values.end())));
  for (const SearchPoint& wall : searchPoints(map, 0, kCell, map.walls.size(), 1)) {
    const int own = valueAt(images, wall.octant, wall.cell);
    EXPECT_EQ(own, most);
    EXPECT_GT(valueAt(images, (wall.octant + 1) % kOctants, wall.cell), 0);
    EXPECT_GT(valueAt(images, wall.octant, {wall.cell.x + 1, wall.cell.y - 1}), 0);
  }
}

TEST(SearchImages, whatNothingIsKnownOfIsWorthNothingAndFreeSpaceLess) {
  const CentredMap map = centred(building());
  const SearchImages images = imagesOf(map, 0, kCell, 1);
  int least = 0;
  for (const auto& values : images.values)
    least = std::min(least, int(*std::min_element(values.begin(), values.end())));
  EXPECT_LT(least, 0);
  std::size_t deep = 0, contradicted = 0;
  for (const auto& [place, isDeep] : map.freePlaces) {
    const Cell cell{int(std::floor(place.x / kCell)), int(std::floor(place.y / kCell))};
    if (!isDeep) continue;
    for (int octant = 0; octant < kOctants; ++octant)
      ++deep, contradicted += valueAt(images, octant, cell) < 0;
  }
  EXPECT_GT(deep, 400u);
  EXPECT_GT(double(contradicted), 0.95 * double(deep)) << "no wall stands in a room's middle";
}

TEST(SearchImages, beyondWhatIsKnownOfARowAllIsZero) {
  const CentredMap map = centred(building());
  const SearchImages images = imagesOf(map, 0.7, kCell, 1);
  std::size_t beyond = 0;
  for (int y = 0; y < images.height; ++y) {
    const auto [first, end] = images.known[std::size_t(y)];
    int low = images.width, high = 0;
    for (const auto& values : images.values)
      for (int x = 0; x < images.width + SearchImages::kMargin; ++x)
        if (values[images.index(x, y)] != 0) low = std::min(low, x), high = std::max(high, x + 1);
    EXPECT_EQ(first, low) << "row " << y;
    EXPECT_EQ(end, high) << "row " << y;
    beyond += std::size_t(images.width - (end - first));
  }
  EXPECT_GT(beyond, images.index(0, images.height) / 5) << "a turned map leaves corners";
}

TEST(SearchImages, aWallThatIsThereTwiceCountsOnce) {
  CentredMap map;
  map.walls.push_back({{0.1, 0.1}, {1, 0}});
  const SearchImages once = imagesOf(map, 0, kCell, 1);
  map.walls.push_back({{0.12, 0.1}, {1, 0}});
  const SearchImages twice = imagesOf(map, 0, kCell, 1);
  for (std::size_t octant = 0; octant < once.values.size(); ++octant)
    EXPECT_EQ(once.values[octant], twice.values[octant]);
  EXPECT_EQ(once.width, 3) << "a margin of one cell";
  EXPECT_EQ(once.height, 3);
}

}  // namespace
}  // namespace roomgraph
