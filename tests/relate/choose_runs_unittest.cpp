#include "choose_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>

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

/** Runs that have seen squares first to last, each with a map and a drive of its own. */
struct Candidates {
  std::vector<Run> runs;
  std::vector<SeenPlaces> seen;

  void add(std::int64_t first, std::int64_t last) {
    runs.emplace_back();
    runs.back().map.states.assign(runs.size(), State::free);
    for (std::uint64_t k = 0; k < 10; ++k) {
      runs.back().scans.emplace_back();
      runs.back().scans.back().scanId = 100 * runs.size() + k;
    }
    SeenPlaces places(std::size_t(last - first + 1));
    std::iota(places.begin(), places.end(), first);
    seen.push_back(places);
  }

  std::vector<std::size_t> core(std::size_t count, std::size_t fixed = 1) const {
    std::vector<const Run*> all;
    for (const Run& run : runs) all.push_back(&run);
    return chooseCore(all, seen, count, fixed);
  }
};

Candidates allSeeAll(std::size_t runs) {
  Candidates candidates;
  for (std::size_t i = 0; i < runs; ++i) candidates.add(0, 99);
  return candidates;
}

using Places = std::vector<std::size_t>;

TEST(ChooseCore, whereAllHaveSeenAllTheFirstAreTaken) {
  EXPECT_EQ(allSeeAll(20).core(6), (Places{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(allSeeAll(3).core(6), (Places{0, 1, 2}));
}

TEST(ChooseCore, whatTheFirstHaveNotSeenIsAdded) {
  Candidates candidates = allSeeAll(10);
  for (int i = 0; i < 3; ++i) candidates.add(50, 199);
  candidates.add(500, 599);  // nobody else has been there
  EXPECT_EQ(candidates.core(6), (Places{0, 1, 2, 3, 10, 11}));
}

TEST(ChooseCore, aSiteOfManyPartsHasUpToTwiceAsMany) {
  Candidates candidates = allSeeAll(6);
  for (int part = 1; part <= 10; ++part)
    for (int i = 0; i < 2; ++i) candidates.add(100 * part, 100 * part + 99);
  EXPECT_EQ(candidates.core(6).size(), 12u);
}

TEST(ChooseCore, aCopyIsNoFurtherJudge) {
  Candidates candidates = allSeeAll(8);
  candidates.runs[1].map = candidates.runs[0].map;
  EXPECT_EQ(candidates.core(6), (Places{0, 2, 3, 4, 5, 6}));
  candidates.runs[0].scans.clear();
  EXPECT_EQ(candidates.core(6, 0), (Places{1, 2, 3, 4, 5, 6})) << "the copy that has scans counts";
}

TEST(ChooseCore, runsOfOneDriveComeAfterOthers) {
  Candidates candidates = allSeeAll(8);
  for (const std::size_t i : {1, 2, 3})
    for (std::size_t k = 0; k < 5; ++k)
      candidates.runs[i].scans[k].scanId = candidates.runs[0].scans[k].scanId;
  EXPECT_EQ(candidates.core(6), (Places{0, 4, 5, 6, 7, 1}));
}

TEST(ChooseCore, theReferenceIsAlwaysTaken) {
  Candidates candidates = allSeeAll(8);
  candidates.runs[1].map = candidates.runs[0].map;
  EXPECT_EQ(candidates.core(3, 2), (Places{0, 1, 2}));
}

SeenPlaces places(std::int64_t first, std::int64_t last) {
  SeenPlaces all(std::size_t(last - first + 1));
  std::iota(all.begin(), all.end(), first);
  return all;
}

using Places = std::vector<std::size_t>;

TEST(ChooseJudges, togetherTheyHaveSeenAllOfTheRun) {
  const std::vector<SeenPlaces> core{places(0, 59), places(0, 50), places(60, 99), places(0, 49)};
  EXPECT_EQ(chooseJudges(places(0, 99), core, 3, 1), (Places{0, 2, 1}));
  EXPECT_EQ(chooseJudges(places(50, 99), core, 2, 0), (Places{2, 0}));
}

TEST(ChooseJudges, ofEqualOnesTheFirstAreTaken) {
  const std::vector<SeenPlaces> core(6, places(0, 99));
  EXPECT_EQ(chooseJudges(places(20, 80), core, 4, 1), (Places{0, 1, 2, 3}));
}

TEST(ChooseJudges, aRunThatSharesNothingHasTheFixedOnesOnly) {
  const std::vector<SeenPlaces> core(3, places(0, 99));
  EXPECT_EQ(chooseJudges(places(200, 300), core, 3, 1), (Places{0}));
  EXPECT_TRUE(chooseJudges({}, {}, 3, 1).empty());
}

using Order = std::vector<std::size_t>;

/** A run that has seen so much, with walls that are so far from right angles. */
roomgraph::Run run(double freeArea, std::optional<double> axisDeviation) {
  roomgraph::Run run;
  run.map.freeArea = freeArea;
  run.map.axisDeviation = axisDeviation;
  return run;
}

TEST(ByStraightness, theStraightestLargeRunComesFirst) {
  EXPECT_EQ(byStraightness({run(90, 0.03), run(100, 0.02), run(60, 0.01)}), (Order{2, 1, 0}));
}

TEST(ByStraightness, whatHasSeenLessThanHalfOfTheLargestComesLast) {
  EXPECT_EQ(byStraightness({run(49, 0.001), run(100, 0.02), run(50, 0.03), run(10, 0.0001)}),
            (Order{1, 2, 3, 0}));
}

TEST(ByStraightness, runsOfWhichItCannotBeToldComeBehindTheOthersOfTheirGroup) {
  EXPECT_EQ(byStraightness({run(100, {}), run(80, 0.5), run(20, 0.1)}), (Order{1, 0, 2}));
}

TEST(ByStraightness, equalOnesKeepTheirOrder) {
  EXPECT_EQ(byStraightness({run(5, 0.1), run(5, 0.1), run(5, 0.1)}), (Order{0, 1, 2}));
  EXPECT_EQ(byStraightness({run(0, {}), run(0, {})}), (Order{0, 1}));
  EXPECT_TRUE(byStraightness({}).empty());
}

}  // namespace
}  // namespace roomgraph
