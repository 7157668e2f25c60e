#include "keep_pairs.h"

#include <gtest/gtest.h>

#include <map>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

/** Three maps, and what is kept of their pairs. */
class KeepPairs : public ::testing::Test {
 protected:
  KeepPairs() : runs_(3) {
    for (std::size_t i = 0; i < 3; ++i)
      runs_[i].map = wallMap(test::drawnBuilding(1, {double(i), 0, 0}));
  }

  MapPair related(const PairOver& pair, const std::string& how = "searched") {
    const RelatePair work = [&](const PairOver&, FullMaps&) {
      ++worked_;
      MapPair found;
      found.alignment.confidence = 0.25;
      return found;
    };
    FullMaps maps;
    return keepPairs(work, runs_, how, kept_)(pair, maps);
  }

  std::vector<roomgraph::Run> runs_;
  std::map<std::string, std::string> shelf_;
  int worked_ = 0;
  KeptPairs kept_{[&](const std::string& name) -> std::optional<std::string> {
                    const auto found = shelf_.find(name);
                    return found == shelf_.end() ? std::nullopt : std::optional(found->second);
                  },
                  [&](const std::string& name, const std::string& bytes) { shelf_[name] = bytes; }};
};

TEST_F(KeepPairs, whatIsKeptIsNotWorkedOutAgain) {
  EXPECT_EQ(related({0, 0, 1}).alignment.confidence, 0.25);
  EXPECT_EQ(related({0, 0, 1}).alignment.confidence, 0.25);
  EXPECT_EQ(worked_, 1);
}

TEST_F(KeepPairs, otherMapsAnotherHubAndAnotherWayAreOtherPairs) {
  related({0, 0, 1}), related({0, 0, 2}), related({2, 0, 1}), related({0, 0, 1}, "aligned");
  EXPECT_EQ(worked_, 4);
  EXPECT_EQ(shelf_.size(), 4u);
}

TEST_F(KeepPairs, aPairIsTheSameOverEitherOfBoth) {
  related({0, 0, 1}), related({1, 0, 1});
  EXPECT_EQ(worked_, 1);
}

TEST_F(KeepPairs, whatIsDamagedIsWorkedOutAgain) {
  related({0, 0, 1});
  shelf_.begin()->second.back() ^= 1;
  related({0, 0, 1});
  EXPECT_EQ(worked_, 2);
}

TEST_F(KeepPairs, withoutAShelfAllIsWorkedOut) {
  kept_ = {};
  related({0, 0, 1}), related({0, 0, 1});
  EXPECT_EQ(worked_, 2);
}

}  // namespace
}  // namespace roomgraph
