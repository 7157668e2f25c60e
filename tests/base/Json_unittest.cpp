#include "roomgraph/base/Json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace roomgraph {
namespace {

TEST(LineOf, keepsTheOrderOfMembersOnOneLine) {
  EXPECT_EQ(lineOf({{"b", 1}, {"a", {2, 3}}}), R"({"b":1,"a":[2,3]})");
}

TEST(LineOf, replacesWhatIsNoUtf8) { EXPECT_EQ(lineOf(Json("a\xff")), "\"a\xEF\xBF\xBD\""); }

TEST(JsonDocument, hasALineForEachMemberAndEachEntry) {
  JsonDocument document("roomgraph/test", nullptr);
  document.add("a", {{"b", 1}});
  document.addList("some", std::vector<int>{1, 2}, [](int number) { return Json(number); });
  document.addList("none", std::vector<int>{}, [](int number) { return Json(number); });
  EXPECT_EQ(std::move(document).text(),
            "{\n\"format\": \"roomgraph/test\",\n\"version\": 1,\n\"a\": {\"b\":1},\n"
            "\"some\": [\n1,\n2\n],\n\"none\": []\n}\n");
}

TEST(Rounded, keepsATenthOfAMillimetre) {
  EXPECT_DOUBLE_EQ(rounded(1.23456), 1.2346);
  EXPECT_EQ(rounded(rounded(1.23456)), rounded(1.23456));
  EXPECT_FALSE(std::signbit(rounded(-0.00004))) << "never -0";
}

std::string text(double value) {
  std::string json;
  addNumber(json, value);
  return json;
}

TEST(AddNumber, roundsToATenthOfAMillimetreAndDropsZeros) {
  EXPECT_EQ(text(1.5), "1.5");
  EXPECT_EQ(text(-12.00016), "-12.0002");
  EXPECT_EQ(text(3), "3");
  EXPECT_EQ(text(0.0501), "0.0501");
  EXPECT_EQ(text(100), "100");
  EXPECT_EQ(text(-0.00001), "0");
}

TEST(AddNumber, keepsLargeNumbersAndWritesNoneForWhatIsNotFinite) {
  EXPECT_EQ(text(1e12), "1e+12");
  EXPECT_EQ(text(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(text(std::nan("")), "null");
}

}  // namespace

}  // namespace roomgraph
