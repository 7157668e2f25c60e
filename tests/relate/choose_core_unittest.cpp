#include "choose_core.h"

#include <gtest/gtest.h>

#include <numeric>

namespace roomgraph {
namespace {

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

}  // namespace
}  // namespace roomgraph
