#include "roomgraph/base/read_document.h"

#include <gtest/gtest.h>

#include "refusal.h"

namespace roomgraph {
namespace {

double weightOf(const std::string& text) {
  return readDocument(text, "a.json", "roomgraph/graph", "weigh it again",
                      [](const JsonNode& top) { return top["thing"]["weight"].number(); });
}

std::string complaintOf(const std::string& text) {
  return test::refusalOf([&] { weightOf(text); });
}

TEST(ReadDocument, givesWhatIsReadFromTheTop) {
  EXPECT_EQ(weightOf(R"({"format": "roomgraph/graph", "thing": {"weight": 2.5}})"), 2.5);
}

TEST(ReadDocument, namesFilePlaceProblemAndRemedy) {
  EXPECT_EQ(complaintOf(R"({"format": "roomgraph/graph", "thing": {"weight": "much"}})"),
            "a.json: thing.weight is not a number; weigh it again");
  EXPECT_EQ(complaintOf(R"({"format": "roomgraph/graph"})"),
            "a.json: the file has no 'thing'; weigh it again");
}

TEST(ReadDocument, refusesWhatIsNoDocumentOfTheFormat) {
  EXPECT_EQ(complaintOf(R"({"format": "something"})"),
            "a.json: is not of format roomgraph/graph; weigh it again");
  EXPECT_EQ(complaintOf(R"({"format": "roomgraph/site"})"),
            "a.json: is of format roomgraph/site, and not roomgraph/graph; give a file of that "
            "format");
  EXPECT_EQ(complaintOf(R"({"format": "roomgraph/graph", })"),
            "a.json: is not JSON, or only a part of it; weigh it again");
}

std::string fault(const std::string& text) { return jsonFault(text, "roomgraph/graph"); }

TEST(JsonFault, nothingIsWrongWithAWholeObjectOfTheFormat) {
  EXPECT_EQ(fault(" {\"format\": \"roomgraph/graph\"}\r\n"), "");
  EXPECT_EQ(fault(R"({"note": "[[{{\"[[", "other": [[[1]]], "format":"roomgraph/graph"})"), "");
}

TEST(FirstLetter, standsBehindBlanksAndAByteOrderMark) {
  EXPECT_EQ(firstLetter(" \r\n\t{}"), '{');
  EXPECT_EQ(firstLetter("\xef\xbb\xbf <a/>"), '<');
  EXPECT_EQ(firstLetter(" \n"), '\0');
}

TEST(JsonFault, aByteOrderMarkIsNoFault) {
  EXPECT_EQ(fault("\xef\xbb\xbf{\"format\": \"roomgraph/graph\"}"), "");
}

TEST(JsonFault, partsAndOtherThingsAreNamed) {
  EXPECT_EQ(fault(""), "is empty");
  EXPECT_EQ(fault(" \n"), "is empty");
  EXPECT_EQ(fault("[1, 2]"), "is not JSON, or only a part of it");
  EXPECT_EQ(fault("{\"format\": \"roomgraph/graph\", \"rooms\": ["),
            "is not JSON, or only a part of it");
  EXPECT_EQ(fault("{\"format\": \"roomgraph/site\"}"), "is not of format roomgraph/graph");
}

TEST(JsonFault, nestingThatWouldFillTheMemoryIsRefused) {
  const auto nested = [](int depth) {
    const std::string text = "{\"format\": \"roomgraph/graph\", \"a\": ";
    return text + std::string(depth, '[') + std::string(depth, ']') + "}";
  };
  EXPECT_EQ(fault(nested(10)), "");
  EXPECT_EQ(fault(nested(1000000)), "is nested too deeply");
}

}  // namespace

}  // namespace roomgraph
