#include "roomgraph/base/CsvReader.h"

#include <gtest/gtest.h>

#include "roomgraph/base/csv_text.h"

namespace roomgraph {
namespace {

using Cells = std::vector<std::string>;

TEST(CsvReader, readsQuotesCommasAndEmptyCells) {
  const std::string text = "name,x,y\r\n\"a, \"\"b\"\"\",1,\n\n" + csvField("c\nd") + ",2,3";
  CsvReader reader(text);
  EXPECT_EQ(reader.nextLine(), (Cells{"name", "x", "y"}));
  EXPECT_EQ(reader.nextLine(), (Cells{"a, \"b\"", "1", ""}));
  EXPECT_EQ(reader.nextLine(), (Cells{""}));
  EXPECT_FALSE(reader.isAtEnd());
  EXPECT_EQ(reader.nextLine(), (Cells{"c\nd", "2", "3"}));
  EXPECT_TRUE(reader.isAtEnd());
  EXPECT_EQ(reader.line(), 4u);
}

TEST(CsvReader, aQuoteWithoutItsEndGoesToTheEnd) {
  const std::string text = "\"a,b\nc";
  CsvReader reader(text);
  EXPECT_EQ(reader.nextLine(), (Cells{"a,b\nc"}));
  EXPECT_TRUE(reader.isAtEnd());
}

}  // namespace
}  // namespace roomgraph
