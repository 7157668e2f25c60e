#include "roomgraph/base/containers.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace roomgraph {
namespace {

TEST(Containers, whatFitsIsTakenOutAndTheRestKeepsItsOrder) {
  std::vector<int> list{3, 4, 1, 2};
  eraseIf(list, [](int i) { return i % 2 == 0; });
  EXPECT_EQ(list, (std::vector<int>{3, 1}));
}

TEST(Containers, ofEqualOnesOneIsKept) {
  std::vector<std::string> list{"b", "a", "b"};
  sortUnique(list);
  EXPECT_EQ(list, (std::vector<std::string>{"a", "b"}));
}

TEST(Containers, listsAndArraysContainValues) {
  const int array[] = {1, 2};
  EXPECT_TRUE(contains(array, 2));
  EXPECT_FALSE(contains(std::vector<std::string>{"a"}, "b"));
}

}  // namespace
}  // namespace roomgraph
