#include "roomgraph/relate/are_storeys.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

/** A floor of 30 m by 16 m with a corridor along it, and walls across at these x on both of its
 *  sides; `furniture` are cupboards of 1.2 m in the middle of the rooms. */
Grid floorWith(const std::vector<double>& walls, bool hasFurniture = false) {
  Grid grid;
  grid.frame = {680, 400, 0.05, {-2, -2}};
  const auto isWall = [&](Point p) {
    const bool isHull = p.x < 0.1 || p.x > 29.9 || p.y < 0.1 || p.y > 15.9;
    const bool isDoor = std::fmod(p.x, 5) < 0.9;
    const bool isOfCorridor = std::abs(p.y - 7) < 0.06 || std::abs(p.y - 9) < 0.06;
    bool isAcross = false, isCupboard = false;
    for (const double x : walls) {
      isAcross = isAcross || (std::abs(p.x - x) < 0.06 && (p.y < 7 || p.y > 9));
      isCupboard = isCupboard || (std::abs(p.x - x - 1.5) < 0.6 && std::abs(p.y - 3) < 0.25);
    }
    return isHull || (isOfCorridor && !isDoor) || isAcross || (hasFurniture && isCupboard);
  };
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) {
      const Point p = grid.frame.center({x, y});
      const bool isIn = p.x > 0 && p.x < 30 && p.y > 0 && p.y < 16;
      grid.cells.push_back(!isIn ? State::unknown : isWall(p) ? State::occupied : State::free);
    }
  return grid;
}

/** The pair as if it were surely aligned where it is, and followed. */
MapPair placed(const WallMap& a, const WallMap& b) {
  MapPair pair;
  pair.alignment.pose = {0.02, 0.01, 0}, pair.alignment.isSameSite = true;
  pair.alignment.confidence = 0.99;
  follow(pair, a, b, {pair.alignment.pose});
  return pair;
}

bool areOfTwoStoreys(const Grid& one, const Grid& other) {
  const WallMap a = wallMap(one), b = wallMap(other);
  return areStoreys(placed(a, b), a, b);
}

const std::vector<double> kLower{4, 9, 12, 17, 21, 26}, kUpper{6.5, 10.5, 14.5, 19, 23.5, 28};

TEST(AreStoreys, outerWallsAgreeAndInnerOnesDoNot) {
  EXPECT_TRUE(areOfTwoStoreys(floorWith(kLower), floorWith(kUpper)));
}

TEST(AreStoreys, oneStoreyIsOneWhateverChangesInIt) {
  const Grid plain = floorWith(kLower);
  EXPECT_FALSE(areOfTwoStoreys(plain, floorWith(kLower)));
  EXPECT_FALSE(areOfTwoStoreys(plain, floorWith(kLower, true))) << "furnished";
  EXPECT_FALSE(areOfTwoStoreys(floorWith({}), plain)) << "walls were built";
  std::vector<double> one = kLower;
  one[2] = 14;
  EXPECT_FALSE(areOfTwoStoreys(plain, floorWith(one))) << "one wall was moved";
}

TEST(AreStoreys, whatIsUnsureBentOrAnEditIsNotAsked) {
  const WallMap a = wallMap(floorWith(kLower)), b = wallMap(floorWith(kUpper));
  const MapPair pair = placed(a, b);
  MapPair other = pair;
  other.alignment.confidence = 0.8;
  EXPECT_FALSE(areStoreys(other, a, b));
  other = pair, other.areEdits = true;
  EXPECT_FALSE(areStoreys(other, a, b));
  other = pair, other.aInB.bend = 3;
  EXPECT_FALSE(areStoreys(other, a, b));
  EXPECT_TRUE(areStoreys(pair, a, b));
}

TEST(AreStoreys, aMapWithHardlyAnyWallsIsNone) {
  const WallMap a = wallMap(test::squareHall({}));
  EXPECT_FALSE(areStoreys(placed(a, a), a, a));
}

}  // namespace
}  // namespace roomgraph
