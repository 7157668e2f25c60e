#include "roomgraph/relate/pair_jobs.h"

#include <gtest/gtest.h>

#include <functional>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

using Jobs = std::vector<std::vector<std::size_t>>;

const std::vector<PairOfThings> kPairs{{0, 1}, {0, 7}, {1, 8}, {1, 7}, {7, 0}, {7, 8}};

TEST(PairJobs, areOnePairEachWhereNoMapIsBare) {
  EXPECT_EQ(pairJobs(kPairs, [](std::size_t) { return false; }),
            (Jobs{{0}, {1}, {2}, {3}, {4}, {5}}));
  EXPECT_EQ(pairJobs({}, [](std::size_t) { return true; }), Jobs{});
}

TEST(PairJobs, holdAllPairsOfABareMapTogether) {
  EXPECT_EQ(pairJobs(kPairs, [](std::size_t map) { return map == 7; }),
            (Jobs{{0}, {1, 3, 4, 5}, {2}}));
  EXPECT_EQ(pairJobs(kPairs, [](std::size_t map) { return map >= 7; }),
            (Jobs{{0}, {1, 3, 4}, {2, 5}}));
}

TEST(VisitPairs, visitsEachOnceAndThoseOfABareMapTogether) {
  std::vector<roomgraph::Run> runs(3);
  Site site;
  for (roomgraph::Run& run : runs) {
    run.map = wallMap(test::drawnBuilding(1, {}));
    site.runs.push_back(&run);
  }
  const std::vector<PairOfThings> pairs = pairsOf(3);
  std::vector<int> visits(pairs.size());
  const auto visit = [&](std::size_t k, FullMaps& maps) {
    ++visits[k];
    EXPECT_FALSE(maps(site.mapOf(pairs[k].first)).isBare());
  };
  std::size_t jobs = 0;
  const auto count = [&](std::size_t n, const std::function<void(std::size_t)>& job) {
    jobs = n;
    oneByOne(n, job);
  };
  visitPairs(site, pairs, count, visit);
  EXPECT_EQ(visits, std::vector<int>(3, 1));
  EXPECT_EQ(jobs, 3u);
  runs[0].map = bareWallMap(test::drawnBuilding(1, {}));
  visitPairs(site, pairs, count, visit);
  EXPECT_EQ(visits, std::vector<int>(3, 2));
  EXPECT_EQ(jobs, 2u) << "two of the bare map, and the third";
}

}  // namespace
}  // namespace roomgraph
