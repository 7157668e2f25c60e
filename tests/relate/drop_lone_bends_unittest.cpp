#include "drop_lone_bends.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/relate/relate_maps.h"

namespace roomgraph {
namespace {

/** Sound runs of one building in one frame, whose pairs lie in each other without a bend. */
struct SoundSite {
  std::vector<Run> runs;
  Site site;
  MapPairs pairs;

  explicit SoundSite(std::size_t count) : runs(count), pairs(count) {
    for (std::size_t i = 0; i < count; ++i) {
      runs[i].map = wallMap(test::drawnBuilding(1, {}));
      site.runs.push_back(&runs[i]);
      site.members.push_back(i);
      site.poses.emplace_back();
    }
    for (const auto& [i, j] : pairs.pairs()) {
      pairs(i, j).bInA.share = pairs(i, j).aInB.share = 1;
      pairs(i, j).bInA.bend = pairs(i, j).aInB.bend = 0.02;
    }
  }

  void drop() {
    dropLoneBends(pairs, std::vector<Transform2D>(pairs.pairs().size()), site, oneByOne);
  }
};

TEST(DropLoneBends, oneThatNobodyElseTellsIsFollowedAnew) {
  SoundSite three(3);
  three.pairs(0, 1).bInA.bend = 12;
  three.drop();
  EXPECT_LT(three.pairs(0, 1).bInA.bend, 0.1);
  EXPECT_FALSE(three.pairs(0, 1).bInA.patches.empty()) << "followed";
  EXPECT_TRUE(three.pairs(0, 2).bInA.patches.empty()) << "as it was";
}

TEST(DropLoneBends, theOtherWayIsAskedForAsWell) {
  SoundSite three(3);
  three.pairs(1, 2).aInB.bend = 12;
  three.drop();
  EXPECT_LT(three.pairs(1, 2).aInB.bend, 0.1);
}

TEST(DropLoneBends, aRunThatIsBentInAllOthersStays) {
  SoundSite three(3);
  three.pairs(0, 2).bInA.bend = three.pairs(1, 2).bInA.bend = 12;
  three.drop();
  EXPECT_EQ(three.pairs(0, 2).bInA.bend, 12);
  EXPECT_EQ(three.pairs(1, 2).bInA.bend, 12);
}

TEST(DropLoneBends, aRunInWhichAllOthersAreBentStays) {
  SoundSite three(3);
  three.pairs(0, 1).bInA.bend = three.pairs(0, 2).bInA.bend = 12;
  three.drop();
  EXPECT_EQ(three.pairs(0, 1).bInA.bend, 12);
}

TEST(DropLoneBends, thatOthersAreSoundInTheOtherMapSaysNothingOfTheRun) {
  SoundSite five(5);
  for (const std::size_t run : {0, 1, 2}) five.pairs(run, 4).bInA.bend = 12;  // it is torn
  five.drop();
  EXPECT_EQ(five.pairs(0, 4).bInA.bend, 12) << "two bear it out, and one denies it";
}

TEST(DropLoneBends, aBendThatBothWaysTellStays) {
  SoundSite three(3);
  three.pairs(0, 1).bInA.bend = 12, three.pairs(0, 1).aInB.bend = 8;
  three.drop();
  EXPECT_EQ(three.pairs(0, 1).bInA.bend, 12);
}

TEST(DropLoneBends, oneThatNobodyCanBeAskedAboutStays) {
  SoundSite two(2);
  two.pairs(0, 1).bInA.bend = 12;
  two.drop();
  EXPECT_EQ(two.pairs(0, 1).bInA.bend, 12) << "there is nobody else";
  SoundSite three(3);
  three.pairs(0, 1).bInA.bend = 12;
  for (FollowedWalls* way : {&three.pairs(0, 2).bInA, &three.pairs(1, 2).bInA,
                             &three.pairs(0, 2).aInB, &three.pairs(1, 2).aInB})
    way->share = 0.5;
  three.drop();
  EXPECT_EQ(three.pairs(0, 1).bInA.bend, 12) << "the third has seen less";
}

TEST(DropLoneBends, runsWithScansStay) {
  SoundSite three(3);
  three.pairs(0, 1).bInA.bend = 12;
  three.runs[0].map.hasScans = three.runs[1].map.hasScans = true;
  three.drop();
  EXPECT_EQ(three.pairs(0, 1).bInA.bend, 12);
  three.runs[1].map.hasScans = false;
  three.drop();
  EXPECT_LT(three.pairs(0, 1).bInA.bend, 0.1) << "one of both is a grid";
}

}  // namespace
}  // namespace roomgraph
