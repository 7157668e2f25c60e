#include <gtest/gtest.h>

#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

TEST(NearestWord, isWhatWasMeant) {
  const std::vector<std::string> words{"extract", "compare", "config", "info", "stability"};
  EXPECT_EQ(nearestWord("exctract", words), "extract");
  EXPECT_EQ(nearestWord("comapre", words), "compare");
  EXPECT_EQ(nearestWord("Config", words), "config");
  EXPECT_EQ(nearestWord("inf", words), "info");
  EXPECT_EQ(nearestWord("extract", words), "extract");
}

TEST(NearestWord, isNoneWhereNothingIsNear) {
  EXPECT_EQ(nearestWord("map.yaml", {"extract", "compare"}), "");
  EXPECT_EQ(nearestWord("", {"extract"}), "");
  EXPECT_EQ(nearestWord(std::string(100000, 'x'), {"extract"}), "");
  EXPECT_EQ(nearestWord("extract", {}), "");
}

TEST(NearestWord, isTheFirstOfEqualOnes) { EXPECT_EQ(nearestWord("bat", {"cat", "bar"}), "cat"); }

}  // namespace
}  // namespace roomgraph
