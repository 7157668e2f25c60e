#include "roomgraph/base/mapped.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace roomgraph {
namespace {

struct Thing {
  std::string name;
  std::size_t length() const { return name.size(); }
};

using Names = std::vector<std::string>;

const std::vector<Thing> kThings{{"b"}, {"aa"}};

TEST(Mapped, takesMembersInTheirOrder) {
  EXPECT_EQ(mapped(kThings, &Thing::name), (Names{"b", "aa"}));
  EXPECT_EQ(mapped(kThings, &Thing::length), (std::vector<std::size_t>{1, 2}));
}

TEST(Mapped, takesFunctions) {
  EXPECT_EQ(mapped(kThings, [](const Thing& thing) { return thing.name + "!"; }),
            (Names{"b!", "aa!"}));
}

TEST(Mapped, takesArraysAndMaps) {
  constexpr const char* words[] = {"x", "y"};
  EXPECT_EQ(mapped(words, [](const char* word) { return std::string(word); }), (Names{"x", "y"}));
  const std::map<int, std::string> byNumber{{2, "two"}, {1, "one"}};
  EXPECT_EQ(mapped(byNumber, [](const auto& one) { return one.second; }), (Names{"one", "two"}));
}

TEST(Mapped, makesNothingOfNothing) { EXPECT_TRUE(mapped(Names(), &std::string::size).empty()); }

}  // namespace
}  // namespace roomgraph
