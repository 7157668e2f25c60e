#include "choose_judges.h"

#include <gtest/gtest.h>

#include <numeric>

namespace roomgraph {
namespace {

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

}  // namespace
}  // namespace roomgraph
