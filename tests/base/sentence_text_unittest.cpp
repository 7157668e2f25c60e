#include "roomgraph/base/sentence_text.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(SentenceText, aTextIsAsLongAsItsFormatMakesIt) {
  EXPECT_EQ(formatted("%.2f m in %zu runs", 0.125, std::size_t(3)), "0.12 m in 3 runs");
  EXPECT_EQ(formatted("%s", std::string(5000, 'x').c_str()), std::string(5000, 'x'));
  EXPECT_EQ(formatted("%s", ""), "");
}

TEST(SentenceText, oneThingIsSingular) {
  EXPECT_EQ(counted(0, "room", "rooms"), "0 rooms");
  EXPECT_EQ(counted(1, "room", "rooms"), "1 room");
  EXPECT_EQ(counted(2, "room", "rooms"), "2 rooms");
}

TEST(SentenceText, theLastNameStandsBehindAnAnd) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"a"}), "a");
  EXPECT_EQ(listed({"a", "b"}), "a and b");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(alternatives({"a"}), "a");
  EXPECT_EQ(alternatives({"a", "b", "c"}), "a, b or c");
}

TEST(SentenceText, manyNamesAreCutShortWhereThatIsShorter) {
  EXPECT_EQ(listed({"a", "b", "c"}, 2), "a, b and c");
  EXPECT_EQ(listed({"a", "b", "c", "d"}, 2), "a, b and 2 more");
}

}  // namespace
}  // namespace roomgraph
