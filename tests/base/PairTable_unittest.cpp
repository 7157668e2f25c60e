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

TEST(PairTable, ofSomePairsTheOthersHaveADefaultValue) {
  PairTable<int> table(5, {{3, 1}, {1, 4}, {0, 1}, {1, 3}});
  EXPECT_EQ(table.pairs(), (Pairs{{0, 1}, {1, 3}, {1, 4}}));
  EXPECT_EQ(table.othersOf(1), (std::vector<std::size_t>{0, 3, 4}));
  EXPECT_TRUE(table.othersOf(2).empty());
  for (const auto& [a, b] : table.pairs()) table(b, a) = int(10 * a + b);
  const PairTable<int>& filled = table;
  EXPECT_EQ(filled(4, 1), 14);
  EXPECT_EQ(filled(0, 1), 1);
  EXPECT_TRUE(filled.has(3, 1));
  EXPECT_FALSE(filled.has(0, 3));
  EXPECT_EQ(filled(0, 3), 0);
}

TEST(DirectedTable, theOrderOfAPairCounts) {
  DirectedTable<int> table(3, {{0, 1}});
  table(0, 1) = 1, table(1, 0) = 2;
  EXPECT_EQ(table(0, 1), 1);
  EXPECT_EQ(table(1, 0), 2);
  EXPECT_EQ(table.othersOf(1), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(table.othersOf(2).empty());
}

}  // namespace
}  // namespace roomgraph
