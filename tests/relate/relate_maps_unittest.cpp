#include "roomgraph/relate/relate_maps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"
#include "sampled_grid.h"

namespace roomgraph {
namespace {

using test::bent;
using test::drawnBuilding;

WallMap mapOfGrid(const Grid& grid) { return wallMap(grid); }

bool areAlike(const Transform2D& l, const Transform2D& r) {
  return distance(l.shift(), r.shift()) < 0.1 && std::abs(wrappedAngle(l.phi - r.phi)) < 0.01;
}

/** Three maps of one building, the first of them bent. */
struct ThreeMaps {
  Transform2D ofA{3, -4, 0.4}, ofB{-7, 2, 2.5}, ofHub{0, 1, -1.2};  // map <- building
  WallMap a = mapOfGrid(bent(drawnBuilding(1, ofA), 0.08)), b = mapOfGrid(drawnBuilding(1, ofB)),
          hub = mapOfGrid(drawnBuilding(1, ofHub));
  MapPair hubAndA = relateMaps(hub, a), hubAndB = relateMaps(hub, b);
};

const ThreeMaps& three() {
  static const ThreeMaps maps;
  return maps;
}

TEST(RelateMaps, thePoseIsThatOfTheBuilding) {
  const ThreeMaps& maps = three();
  EXPECT_TRUE(maps.hubAndB.alignment.isSameSite);
  EXPECT_TRUE(areAlike(maps.hubAndB.alignment.pose, maps.ofHub * maps.ofB.inverse()));
  EXPECT_LT(maps.hubAndB.bInA.bend, 0.05) << "neither is bent";
  EXPECT_GT(maps.hubAndA.bInA.bend, 3 * maps.hubAndB.bInA.bend) << "one is bent";
  EXPECT_FALSE(maps.hubAndB.areIdentical);
}

TEST(RelateMaps, namingAPairTheOtherWayRoundSwapsTheAnswers) {
  const MapPair one = relateMaps(three().a, three().b);
  const MapPair back = swapped(relateMaps(three().b, three().a));
  EXPECT_TRUE(areAlike(one.alignment.pose, back.alignment.pose));
  EXPECT_NEAR(one.bInA.bend, back.bInA.bend, 1e-9);
  EXPECT_NEAR(one.aInB.share, back.aInB.share, 1e-9);
}

TEST(RelateMaps, ofOtherBuildingsNothingIsFollowed) {
  const MapPair pair = relateMaps(three().a, mapOfGrid(drawnBuilding(11, {})));
  EXPECT_FALSE(pair.alignment.isSameSite);
  EXPECT_TRUE(pair.bInA.patches.empty());
  EXPECT_TRUE(pair.aInB.patches.empty());
}

TEST(RelateMaps, ofMapsThatAreSaidToShowOneSiteTheLikeliestPoseIsTaken) {
  Alignment alignment;
  alignment.confidence = 0.17, alignment.runnerUpConfidence = 0.03, alignment.siteConfidence = 0.2;
  Alignment unclear = alignment;
  takeLikeliest(alignment);
  EXPECT_TRUE(alignment.isSameSite && alignment.isOnlySaid);
  EXPECT_NEAR(alignment.confidence, 0.85, 1e-9);
  EXPECT_NEAR(alignment.runnerUpConfidence, 0.15, 1e-9);
  EXPECT_EQ(alignment.siteConfidence, 0.2) << "it stays as doubtful as it is";
  unclear.runnerUpConfidence = 0.1;
  takeLikeliest(unclear);
  EXPECT_FALSE(unclear.isSameSite) << "another pose is about as likely";
}

TEST(RelateMaps, whatIsSaidOfMapsChangesNothingWhereTheyShowIt) {
  const Alignment said = relateMaps(three().a, three().b, true).alignment;
  EXPECT_FALSE(said.isOnlySaid);
  EXPECT_EQ(said.confidence, relateMaps(three().a, three().b).alignment.confidence);
  const WallMap other = mapOfGrid(drawnBuilding(11, {}));
  EXPECT_FALSE(relateMaps(three().a, other, true).alignment.isSameSite)
      << "another pose is about as likely";
}

TEST(RelateMaps, overAHubTheAnswerIsThatOfASearch) {
  const MapPair over = relateMapsOver(three().hubAndA, three().hubAndB, three().a, three().b);
  const MapPair searched = relateMaps(three().a, three().b);
  EXPECT_TRUE(areAlike(over.alignment.pose, searched.alignment.pose));
  EXPECT_NEAR(over.bInA.bend, searched.bInA.bend, 0.03);
  EXPECT_LE(over.alignment.confidence,
            std::min(three().hubAndA.alignment.confidence, three().hubAndB.alignment.confidence))
      << "no surer than what it follows from";
}

TEST(RelateMaps, ofAnUnsureHubAllAnswersAreTried) {
  MapPair hubAndB = three().hubAndB;
  Alignment& unsure = hubAndB.alignment;
  const Transform2D right = unsure.pose;
  unsure.pose = right * carrying(three().b.middle(), three().b.middle(), M_PI);
  unsure.poses = {unsure.pose, right};
  unsure.confidence = 0.4, unsure.runnerUpConfidence = 0.3;
  hubAndB.bInA = {};
  const MapPair over = relateMapsOver(three().hubAndA, hubAndB, three().a, three().b);
  EXPECT_TRUE(over.alignment.isSameSite);
  EXPECT_TRUE(areAlike(over.alignment.pose, three().hubAndA.alignment.pose.inverse() * right));
  EXPECT_LE(over.alignment.confidence, 0.7) << "surer than the hub";
}

TEST(RelateMaps, sureAnswersThatContradictEachOtherAreSearchedForAgain) {
  MapPair wrong = three().hubAndA;
  const Transform2D away = Transform2D{60, 0, 0} * wrong.alignment.pose;
  wrong.alignment.pose = away, wrong.alignment.poses = {away};
  wrong.alignment.confidence = 1, wrong.alignment.runnerUpConfidence = 0;
  wrong.bInA = {};
  const MapPair over = relateMapsOver(wrong, three().hubAndB, three().a, three().b);
  EXPECT_TRUE(over.alignment.isSameSite);
  EXPECT_TRUE(areAlike(over.alignment.pose, relateMaps(three().a, three().b).alignment.pose));
}

TEST(RelateMaps, framesThatContradictEachOtherAreNotTakenForOne) {
  const WallMap map = mapOfGrid(drawnBuilding(1, {}));
  const auto areOfOneSite = [&](const Transform2D& pose) {
    return relateAlignedMaps(map, mapOfGrid(drawnBuilding(1, pose))).alignment.isSameSite;
  };
  EXPECT_TRUE(areOfOneSite({0.05, 0, 0.005}));
  EXPECT_FALSE(areOfOneSite({4, 2, 1}));
  EXPECT_FALSE(areOfOneSite({90, 0, 0}));
}

TEST(RelateMaps, aMirroredMapIsNotOfTheSameSite) {
  const MapPair pair = relateMaps(three().b, mirrored(three().hub));
  EXPECT_TRUE(pair.alignment.isMirrored);
  EXPECT_FALSE(pair.alignment.isSameSite);
  EXPECT_EQ(pair.alignment.confidence, 0);
  EXPECT_TRUE(pair.bInA.patches.empty());
  for (const MapPair& sound : {three().hubAndA, three().hubAndB})
    EXPECT_FALSE(sound.alignment.isMirrored);
}

TEST(RelateMaps, aSymmetricHallIsNotMirrored) {
  const MapPair pair =
      relateMaps(mapOfGrid(test::squareHall({})), mapOfGrid(test::squareHall({4, 1, 0.2})));
  EXPECT_FALSE(pair.alignment.isMirrored) << "it is its own mirror image";
  EXPECT_TRUE(pair.alignment.isSameSite);
}

TEST(RelateMaps, editsOfOnePictureAreTold) {
  const Grid picture = drawnBuilding(1, {});
  Grid moved = picture;
  moved.frame.origin = {7, 8};
  EXPECT_TRUE(relateMaps(mapOfGrid(picture), mapOfGrid(moved)).areEdits);
  EXPECT_FALSE(relateMaps(mapOfGrid(picture), mapOfGrid(moved)).areIdentical);
  EXPECT_FALSE(three().hubAndB.areEdits);
  EXPECT_TRUE(relateAlignedMaps(mapOfGrid(picture), mapOfGrid(picture)).areEdits);
}

TEST(RelateMaps, copiesHaveNoBend) {
  const MapPair pair = relateMaps(three().b, three().b);
  EXPECT_TRUE(pair.areIdentical);
  EXPECT_EQ(pair.bInA.bend, 0);
  EXPECT_EQ(pair.aInB.share, 1);
}

/** A floor of 30 m by 16 m with a corridor along it, and walls across at these x on both of its
 *  sides; `furniture` are cupboards of 1.2 m in the middle of the rooms. */
Grid floorWith(const std::vector<double>& walls, bool hasFurniture = false) {
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
  return test::sampledGrid({680, 400, 0.05, {-2, -2}}, [&](Point p) {
    const bool isIn = p.x > 0 && p.x < 30 && p.y > 0 && p.y < 16;
    return !isIn ? State::unknown : isWall(p) ? State::occupied : State::free;
  });
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
