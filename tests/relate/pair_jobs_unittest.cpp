#include "roomgraph/relate/pair_jobs.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace roomgraph
