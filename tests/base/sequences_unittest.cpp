#include "roomgraph/base/sequences.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace roomgraph {
namespace {

using Words = std::vector<std::string>;

TEST(Sequences, whatFitsIsTakenOutAndTheRestKeepsItsOrder) {
  std::vector<int> list{3, 4, 1, 2};
  eraseIf(list, [](int i) { return i % 2 == 0; });
  EXPECT_EQ(list, (std::vector<int>{3, 1}));
}

TEST(Sequences, ofEqualOnesOneIsKept) {
  Words list{"b", "a", "b"};
  sortUnique(list);
  EXPECT_EQ(list, (Words{"a", "b"}));
}

TEST(Sequences, listsAndArraysContainValues) {
  const int array[] = {1, 2};
  EXPECT_TRUE(contains(array, 2));
  EXPECT_FALSE(contains(Words{"a"}, "b"));
}

TEST(Sequences, whatFitsIsCountedAndFound) {
  Words words{"a", "", "bb"};
  EXPECT_TRUE(anyOf(words, &std::string::empty));
  EXPECT_FALSE(allOf(words, &std::string::empty));
  EXPECT_EQ(countIf(words, [](const std::string& word) { return !word.empty(); }), 2u);
  const auto isLong = [](const std::string& word) { return word.size() > 1; };
  EXPECT_EQ(findIf(words, isLong), &words[2]);
  words.pop_back();
  EXPECT_EQ(findIf(words, isLong), nullptr);
}

TEST(Sequences, numbersRunToBeforeTheEnd) {
  EXPECT_EQ(numbersFrom(2, 5), (std::vector<std::size_t>{2, 3, 4}));
  EXPECT_TRUE(numbersFrom(3, 3).empty());
}

TEST(Sequences, whatIsSortedByTheSameStaysInItsOrder) {
  const Words words{"bb", "aaa", "aa", "b"};
  Words least = words, most = words;
  sortBy(least, &std::string::size);
  sortDownBy(most, [](const std::string& word) { return word.size(); });
  EXPECT_EQ(least, (Words{"b", "bb", "aa", "aaa"}));
  EXPECT_EQ(most, (Words{"aaa", "bb", "aa", "b"}));
}

struct Thing {
  std::string name;
  std::size_t length() const { return name.size(); }
};

const std::vector<Thing> kThings{{"b"}, {"aa"}};

TEST(Mapped, takesMembersInTheirOrder) {
  EXPECT_EQ(mapped(kThings, &Thing::name), (Words{"b", "aa"}));
  EXPECT_EQ(mapped(kThings, &Thing::length), (std::vector<std::size_t>{1, 2}));
}

TEST(Mapped, takesFunctions) {
  EXPECT_EQ(mapped(kThings, [](const Thing& thing) { return thing.name + "!"; }),
            (Words{"b!", "aa!"}));
}

TEST(Mapped, takesArraysAndMaps) {
  constexpr const char* words[] = {"x", "y"};
  EXPECT_EQ(mapped(words, [](const char* word) { return std::string(word); }), (Words{"x", "y"}));
  const std::map<int, std::string> byNumber{{2, "two"}, {1, "one"}};
  EXPECT_EQ(mapped(byNumber, [](const auto& one) { return one.second; }), (Words{"one", "two"}));
}

TEST(Mapped, makesNothingOfNothing) { EXPECT_TRUE(mapped(Words(), &std::string::size).empty()); }

}  // namespace
}  // namespace roomgraph
