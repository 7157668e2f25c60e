#include "roomgraph/base/PairTable.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

TEST(PairTable, aPairIsTheSameWhicheverIsNamedFirst) {
  PairTable<int> table(4);
  int next = 0;
  for (const auto& [a, b] : table.pairs()) table(b, a) = next++;
  next = 0;
  for (const auto& [a, b] : table.pairs()) EXPECT_EQ(table(a, b), next++);
  EXPECT_EQ(table.values(), (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

TEST(PairTable, pairsComeByTheirFirstThingThenTheirSecond) {
  EXPECT_EQ(pairsOf(3), (Pairs{{0, 1}, {0, 2}, {1, 2}}));
  for (const std::size_t few : {0u, 1u}) {
    EXPECT_TRUE(pairsOf(few).empty());
    EXPECT_TRUE(PairTable<int>(few).values().empty());
  }
}

TEST(DirectedTable, theOrderOfAPairCounts) {
  DirectedTable<int> table(2);
  table(0, 1) = 1, table(1, 0) = 2;
  EXPECT_EQ(table(0, 1), 1);
  EXPECT_EQ(table(1, 0), 2);
  EXPECT_EQ(table(0, 0), 0);
}

}  // namespace
}  // namespace roomgraph
