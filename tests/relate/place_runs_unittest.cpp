#include "roomgraph/relate/place_runs.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/relate/relate_maps.h"

namespace roomgraph {
namespace {

/** Runs of one building in frames of their own, and where their pairs were found. */
struct RunsOfABuilding {
  std::vector<Transform2D> truth{{}, {3, -1, 0.4}, {-6, 2, 2}, {1, 8, -1.5}, {0, 0, 3}};
  std::vector<roomgraph::Run> runs;
  MapPairs related{5};

  RunsOfABuilding() {
    for (const Transform2D& pose : truth) {
      runs.emplace_back();
      runs.back().map = wallMap(test::drawnBuilding(1, pose));
    }
    for (const auto& [a, b] : related.pairs()) join(a, b, 0.9);
  }

  /** The pair was found, with this confidence, where it really lies. */
  void join(std::size_t a, std::size_t b, double confidence) {
    Alignment& alignment = related(a, b).alignment;
    alignment.isSameSite = confidence > 0;
    alignment.confidence = confidence;
    alignment.pose = truth[a] * truth[b].inverse();
    alignment.poses = {alignment.pose};
  }

  Site placed(std::optional<std::size_t> reference = {}) const {
    return placeRuns(runs, related, reference);
  }
};

void expectSame(const Transform2D& l, const Transform2D& r) {
  EXPECT_LT(distance(l.shift(), r.shift()), 1e-6);
  EXPECT_NEAR(wrappedAngle(l.phi - r.phi), 0, 1e-9);
}

TEST(IsJoined, aPairMustBeOfOneSiteAndSureEnough) {
  MapPair pair;
  pair.alignment.confidence = 0.9;
  EXPECT_FALSE(isJoined(pair)) << "not of one site";
  pair.alignment.isSameSite = true;
  EXPECT_TRUE(isJoined(pair));
  pair.alignment.confidence = 0.4;
  EXPECT_FALSE(isJoined(pair)) << "nor is it anywhere else";
  pair.alignment.runnerUpConfidence = 0.3;
  EXPECT_TRUE(isJoined(pair)) << "it lies in one of two turns";
  pair.alignment.confidence = 0.2;
  EXPECT_FALSE(isJoined(pair)) << "less than the least that is used";
}

TEST(PlaceRuns, allLieWhereTheyReallyDo) {
  const RunsOfABuilding five;
  const Site site = five.placed();
  EXPECT_EQ(site.members, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  ASSERT_EQ(site.poses.size(), 5u);
  EXPECT_TRUE(site.others.empty());
  EXPECT_FALSE(site.reference);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(site.runs[i], &five.runs[i]);
    expectSame(site.poses[0].inverse() * site.poses[i], five.truth[0] * five.truth[i].inverse());
  }
}

TEST(PlaceRuns, aMirrorImageIsNotOfTheSiteThoughItFitsOneRunByChance) {
  RunsOfABuilding five;
  for (const std::size_t other : {0u, 1u, 2u}) {
    five.join(other, 4, 0);
    five.related(other, 4).alignment.isMirrored = true;
  }
  five.join(3, 4, 0.6);
  EXPECT_EQ(five.placed().members, (std::vector<std::size_t>{0, 1, 2, 3}));
  for (const std::size_t other : {1u, 2u}) {
    five.join(other, 4, 0.95);
    five.related(other, 4).alignment.isMirrored = false;
  }
  EXPECT_EQ(five.placed().members.size(), 5u) << "one pair is wrong, two are sure";
}

TEST(PlaceRuns, storeysStayApartThoughOnePairIsTakenForOne) {
  RunsOfABuilding five;  // 0, 1 and 2 are of one storey, 3 and 4 of another
  for (const std::size_t low : {0u, 1u, 2u})
    for (const std::size_t high : {3u, 4u}) {
      five.join(low, high, 0);
      five.related(low, high).areStoreys = true;
    }
  five.join(2, 4, 0.7);
  five.related(2, 4).areStoreys = false;
  const Site site = five.placed();
  EXPECT_EQ(site.members, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(site.others, (std::vector<std::vector<std::size_t>>{{3, 4}}));
}

TEST(PlaceRuns, theFrameIsThatOfTheReference) {
  const RunsOfABuilding five;
  for (const std::size_t reference : {0u, 3u}) {
    const Site site = five.placed(reference);
    EXPECT_EQ(site.reference, reference);
    expectSame(site.poses[reference], {});
  }
}

TEST(PlaceRuns, withoutAReferenceItIsThatOfTheRunThatTheOthersFitBest) {
  RunsOfABuilding five;
  for (const auto& [a, b] : five.related.pairs()) five.join(a, b, a == 2 || b == 2 ? 0.95 : 0.7);
  expectSame(five.placed().poses[2], {});
}

TEST(PlaceRuns, theSiteIsTheLargestSetThatIsJoined) {
  RunsOfABuilding five;
  for (const auto& [a, b] : five.related.pairs())
    five.join(a, b, (a < 2) == (b < 2) ? 0.9 : 0);  // 0 and 1; 2, 3 and 4
  const Site site = five.placed();
  EXPECT_EQ(site.members, (std::vector<std::size_t>{2, 3, 4}));
  EXPECT_EQ(site.others, (std::vector<std::vector<std::size_t>>{{0, 1}}));
  EXPECT_EQ(site.runs[0], &five.runs[2]);
  const Site referred = five.placed(1);
  EXPECT_EQ(referred.members, (std::vector<std::size_t>{0, 1})) << "that of the reference";
  EXPECT_EQ(referred.reference, 1u);
  EXPECT_EQ(referred.others, (std::vector<std::vector<std::size_t>>{{2, 3, 4}}));
}

TEST(PlaceRuns, ofEquallyLargeSetsTheSurerIsTheSite) {
  RunsOfABuilding five;
  for (const auto& [a, b] : five.related.pairs()) five.join(a, b, 0);
  five.join(0, 1, 0.7), five.join(3, 4, 0.9);
  EXPECT_EQ(five.placed().members, (std::vector<std::size_t>{3, 4}));
  five.join(0, 1, 0.95);
  EXPECT_EQ(five.placed().members, (std::vector<std::size_t>{0, 1}));
}

TEST(PlaceRuns, runsThatNothingJoinsAreInNoSet) {
  RunsOfABuilding five;
  for (const auto& [a, b] : five.related.pairs()) five.join(a, b, 0);
  const Site site = five.placed();
  EXPECT_EQ(site.members.size(), 1u);
  EXPECT_TRUE(site.others.empty()) << "of one run there is nothing to compare";
  EXPECT_TRUE(placeRuns({}, {}, {}).runs.empty());
}

TEST(PlaceRuns, aRunThatOneOtherFoundIsPlacedThroughIt) {
  RunsOfABuilding five;
  for (const auto& [a, b] : five.related.pairs()) five.join(a, b, b == a + 1 ? 0.9 : 0);
  const Site site = five.placed();
  ASSERT_EQ(site.members.size(), 5u);
  expectSame(site.poses[0].inverse() * site.poses[4], five.truth[0] * five.truth[4].inverse());
}

TEST(PairsInSite, aPairThatLiesOtherwiseInItselfIsFollowedAgain) {
  RunsOfABuilding five;
  MapPairs& related = five.related;
  for (const auto& [a, b] : related.pairs())
    follow(related(a, b), five.runs[a].map, five.runs[b].map, {related(a, b).alignment.pose});
  const double share = related(1, 2).bInA.share;
  ASSERT_GT(share, 0.9);
  related(1, 2).bInA = related(1, 2).aInB = {};  // bent maps that did not find each other
  related.core = {0, 2, 4};
  const Site site = five.placed();
  const MapPairs pairs = pairsInSite(site, related, oneByOne);
  EXPECT_NEAR(pairs(1, 2).bInA.share, share, 0.02);
  EXPECT_GT(pairs(1, 2).aInB.share, 0.9);
  EXPECT_EQ(pairs(0, 1).bInA.patches.size(), related(0, 1).bInA.patches.size()) << "as it was";
  EXPECT_EQ(pairs.core, related.core);
}

TEST(PairsInSite, whatTheSiteDoesNotBearOutKeepsItsOwnAnswer) {
  RunsOfABuilding five;
  MapPairs& related = five.related;
  for (const auto& [a, b] : related.pairs())
    follow(related(a, b), five.runs[a].map, five.runs[b].map, {related(a, b).alignment.pose});
  Site site = five.placed();
  site.poses[4] = site.poses[4] * Transform2D{40, 0, 1};  // a site that is wrong
  const MapPairs pairs = pairsInSite(site, related, oneByOne);
  EXPECT_EQ(pairs(0, 4).bInA.share, related(0, 4).bInA.share);
}

TEST(PairsInSite, onlyThePairsOfItsRunsAreKept) {
  RunsOfABuilding five;
  for (const auto& [a, b] : five.related.pairs()) five.join(a, b, (a < 2) == (b < 2) ? 0.9 : 0);
  five.related.core = {1, 2, 4};
  const MapPairs pairs = pairsInSite(five.placed(), five.related, oneByOne);
  EXPECT_EQ(pairs.things(), 3u);
  EXPECT_EQ(pairs.pairs(), pairsOf(3));
  EXPECT_EQ(pairs.core, (std::vector<std::size_t>{0, 2})) << "by their places in the site";
}

TEST(FollowedIn, namesTheOneOfBothWays) {
  MapPairs pairs(3);
  pairs(0, 2).bInA.share = 0.25, pairs(0, 2).aInB.share = 0.75;
  EXPECT_EQ(followedIn(pairs, 2, 0).share, 0.25);
  EXPECT_EQ(followedIn(pairs, 0, 2).share, 0.75);
}

TEST(BendsOf, theLargerBendAndTheSmallerShareCount) {
  MapPairs pairs(3, {{0, 1}, {1, 2}});
  MapPair& pair = pairs(0, 1);
  pair.bInA.bend = 0.1, pair.aInB.bend = 0.3;
  pair.bInA.share = 0.9, pair.aInB.share = 0.5;
  pair.bInA.patches.resize(2), pair.aInB.patches.resize(1);
  pair.bInA.patches[0].walls = 10, pair.bInA.patches[1].walls = 20;
  pair.aInB.patches[0].walls = 5;
  pairs(1, 2).areIdentical = true;
  const PairBends bends = bendsOf(pairs);
  EXPECT_EQ(bends(1, 0).bend, 0.3);
  EXPECT_EQ(bends(1, 0).share, 0.5);
  EXPECT_EQ(bends(1, 0).walls, 35);
  EXPECT_FALSE(bends(0, 1).areIdentical);
  EXPECT_TRUE(bends(1, 2).areIdentical);
  EXPECT_FALSE(bends.has(0, 2)) << "they were not related";
}

TEST(BendsOf, ofTwoRunsAloneTheWayThatTellsLessDisagreesWhereItFollowsAsMuch) {
  MapPairs pairs(2);
  MapPair& pair = pairs(0, 1);
  pair.bInA.bend = 10, pair.bInA.share = 0.9;
  pair.aInB.bend = 0.5, pair.aInB.share = 0.8;
  EXPECT_NEAR(bendsOf(pairs)(0, 1).agreement, 0.05, 1e-9);
  std::swap(pair.bInA, pair.aInB);
  EXPECT_NEAR(bendsOf(pairs)(0, 1).agreement, 0.05, 1e-9);
  pair.bInA.share = 0.6;
  EXPECT_EQ(bendsOf(pairs)(0, 1).agreement, 1) << "it may have followed one part of a torn map";
  pair.bInA.bend = pair.aInB.bend = 0;
  EXPECT_EQ(bendsOf(pairs)(0, 1).agreement, 1);
  MapPairs three(3);
  three(0, 1).bInA.bend = 10, three(0, 1).aInB.bend = 0.5;
  EXPECT_EQ(bendsOf(three)(0, 1).agreement, 1) << "the third was asked";
}

TEST(Site, runsAreFoundByNameAndByFile) {
  std::vector<roomgraph::Run> runs(2);
  runs[0].name = "a", runs[0].file = "maps/a.yaml", runs[1].name = "b", runs[1].file = "b.yaml";
  EXPECT_EQ(findRun(runs, "b"), &runs[1]);
  EXPECT_EQ(findRun(runs, "b.yaml"), nullptr);
  Site site;
  site.runs = {&runs[1]};
  EXPECT_EQ(site.placeOf("b.yaml"), std::size_t(0));
  EXPECT_FALSE(site.placeOf("maps/a.yaml")) << "of another site";
}

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
