#include "roomgraph/page/site_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace roomgraph {
namespace {

/** A map with a frame of `text`'s size and cells of 1 m; '#' wall, '.' free, ' ' unknown; the last
 *  line is the lowest. */
WallMap drawn(const std::vector<std::string>& text) {
  WallMap map;
  map.frame.width = int(text[0].size()), map.frame.height = int(text.size());
  map.frame.resolution = 1;
  for (auto row = text.rbegin(); row != text.rend(); ++row)
    for (const char c : *row)
      map.states.push_back(c == '#' ? State::occupied : c == '.' ? State::free : State::unknown);
  return map;
}

const std::vector<std::string> kHall = {"#####", "#...#", "#...#", "#...#", "#####"};
const std::vector<std::string> kHallWithWall = {"#####", "#.#.#", "#.#.#", "#.#.#", "#####"};

TEST(SitePictures, theBoxHoldsAllThatIsKnownAndNoMore) {
  const WallMap map = drawn({"    ", " .# ", "    "});
  const Box box = knownBox({{&map, {10, 20, 0}}});
  EXPECT_NEAR(box.low.x, 11, 0.3);
  EXPECT_NEAR(box.low.y, 21, 0.3);
  EXPECT_NEAR(box.high.x, 13, 0.3);
  EXPECT_NEAR(box.high.y, 22, 0.3);
}

TEST(SitePictures, nothingKnownGivesNoPicture) {
  const WallMap map = drawn({"   "});
  EXPECT_TRUE(runPicture({&map, {}}, {}, 0.5).png.empty());
  EXPECT_TRUE(heatPicture(disagreementOf({{&map, {}}, {&map, {}}}, 1)).png.empty());
  EXPECT_TRUE(heatPicture(disagreementOf({}, 1)).png.empty());
}

TEST(SitePictures, aLargeSiteHasLargePixels) {
  const WallMap map = drawn(kHall);
  EXPECT_DOUBLE_EQ(pixelFor({{0, 0}, {5, 5}}, {{&map, {}}}, 100), 0.5);
  const double pixel = pixelFor({{0, 0}, {1000, 10}}, {{&map, {}}}, 101);
  EXPECT_DOUBLE_EQ(pixel, 10);
}

TEST(SitePictures, noPictureIsLargerThanAsked) {
  WallMap map = drawn(std::vector<std::string>(40, std::string(400, '.')));
  const std::vector<PlacedMap> maps = {{&map, {0.123, 7.7, 0.4}}};
  const double pixel = pixelFor(knownBox(maps), maps, 50);
  const SitePicture picture = runPicture(maps[0], {}, pixel);
  EXPECT_LE(picture.box.high.x - picture.box.low.x, 50.001 * pixel);
  EXPECT_LE(picture.box.high.y - picture.box.low.y, 50.001 * pixel);
}

TEST(SitePictures, runsThatAgreeHaveNoHeat) {
  const WallMap map = drawn(kHall);
  const Disagreement result = disagreementOf({{&map, {}}, {&map, {}}}, 1);
  EXPECT_EQ(*std::max_element(result.shares.begin(), result.shares.end()), 0);
}

TEST(SitePictures, aWallThatOneOfThreeHasIsSeenOtherwiseByAThird) {
  const WallMap hall = drawn(kHall), wall = drawn(kHallWithWall);
  const Disagreement result = disagreementOf({{&hall, {}}, {&wall, {}}, {&hall, {}}}, 1);
  const Cell middle = result.frame.cellAt({2.5, 2.5});
  EXPECT_NEAR(double(result.shares[result.frame.index(middle)]), 1.0 / 3, 1e-6);
  EXPECT_FALSE(heatPicture(result).png.empty());
}

TEST(SitePictures, whatOnlyOneRunHasSeenIsNoDisagreement) {
  const WallMap hall = drawn(kHall), nothing = drawn({"     "});
  const Disagreement result = disagreementOf({{&hall, {}}, {&nothing, {}}}, 1);
  EXPECT_EQ(*std::max_element(result.shares.begin(), result.shares.end()), 0);
}

TEST(SitePictures, aWallOneCellAsideIsNoDisagreement) {
  const WallMap left = drawn({"..........", "...#......", ".........."});
  const WallMap right = drawn({"..........", "....#.....", ".........."});
  const Disagreement result = disagreementOf({{&left, {}}, {&right, {}}}, 1);
  EXPECT_EQ(*std::max_element(result.shares.begin(), result.shares.end()), 0);
}

TEST(SitePictures, patternsLeaveOutHalfOfTheWallsEachInItsWay) {
  const WallMap map = drawn(kHall);
  std::set<std::string> pictures;
  for (const RunPattern pattern :
       {RunPattern::solid, RunPattern::rising, RunPattern::falling, RunPattern::dotted})
    pictures.insert(runPicture({&map, {}}, {{1, 2, 3}, pattern}, 0.3).png);
  EXPECT_EQ(pictures.size(), 4u);
}

TEST(SitePictures, aMapIsLessThanAPixelWhereRunsLieFarApart) {
  const WallMap map = drawn(kHall);
  const SitePicture picture = runPicture({&map, {9e7, 0, 0}}, {{1, 2, 3}}, 4e4);
  EXPECT_LE(picture.box.high.x - picture.box.low.x, 2 * 4e4 + 1);
  EXPECT_FALSE(picture.png.empty());
}

TEST(SitePictures, theSameMapGivesTheSameBytes) {
  const WallMap map = drawn(kHall);
  const PlacedMap placed{&map, {1, 2, 0.3}};
  EXPECT_EQ(runPicture(placed, {{1, 2, 3}}, 0.3).png, runPicture(placed, {{1, 2, 3}}, 0.3).png);
}

}  // namespace

}  // namespace roomgraph
