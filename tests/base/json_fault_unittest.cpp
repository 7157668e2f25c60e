#include "roomgraph/base/json_fault.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

std::string fault(const std::string& text) { return jsonFault(text, "roomgraph/graph"); }

TEST(JsonFault, nothingIsWrongWithAWholeObjectOfTheFormat) {
  EXPECT_EQ(fault(" {\"format\": \"roomgraph/graph\"}\r\n"), "");
  EXPECT_EQ(fault(R"({"note": "[[{{\"[[", "other": [[[1]]], "format":"roomgraph/graph"})"), "");
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
