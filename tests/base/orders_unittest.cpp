#include "roomgraph/base/orders.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace roomgraph {
namespace {

using Words = std::vector<std::string>;

const Words kWords{"bb", "aaa", "aa", "b"};

TEST(Orders, numbersRunToBeforeTheEnd) {
  EXPECT_EQ(numbersFrom(2, 5), (std::vector<std::size_t>{2, 3, 4}));
  EXPECT_TRUE(numbersFrom(3, 3).empty());
}

TEST(Orders, whatHasTheSameOfItStaysInItsOrder) {
  Words least = kWords, most = kWords;
  sortBy(least, &std::string::size);
  sortDownBy(most, [](const std::string& word) { return word.size(); });
  EXPECT_EQ(least, (Words{"b", "bb", "aa", "aaa"}));
  EXPECT_EQ(most, (Words{"aaa", "bb", "aa", "b"}));
}

}  // namespace
}  // namespace roomgraph
