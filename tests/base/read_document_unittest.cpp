#include "roomgraph/base/read_document.h"

#include <gtest/gtest.h>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

double weightOf(const std::string& text) {
  return readDocument(text, "a.json", "roomgraph/graph", "weigh it again",
                      [](const JsonNode& top) { return top["thing"]["weight"].number(); });
}

std::string complaintOf(const std::string& text) {
  try {
    weightOf(text);
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
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

}  // namespace
}  // namespace roomgraph
