#include "roomgraph/base/Json.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(LineOf, keepsTheOrderOfMembersOnOneLine) {
  EXPECT_EQ(lineOf({{"b", 1}, {"a", {2, 3}}}), R"({"b":1,"a":[2,3]})");
}

TEST(LineOf, replacesWhatIsNoUtf8) { EXPECT_EQ(lineOf(Json("a\xff")), "\"a\xEF\xBF\xBD\""); }

}  // namespace
}  // namespace roomgraph
