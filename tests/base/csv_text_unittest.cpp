#include "roomgraph/base/csv_text.h"

#include <gtest/gtest.h>

#include <cmath>

#include "refusal.h"

namespace roomgraph {
namespace {

TEST(CsvField, isQuotedWhereItMustBe) {
  EXPECT_EQ(csvField("office"), "office");
  EXPECT_EQ(csvField(""), "");
  EXPECT_EQ(csvField("a,b"), "\"a,b\"");
  EXPECT_EQ(csvField("a \"b\""), "\"a \"\"b\"\"\"");
  EXPECT_EQ(csvField("a\nb"), "\"a\nb\"");
}

TEST(CsvField, aFormulaIsText) {
  EXPECT_EQ(csvField("=1+1"), "'=1+1");
  EXPECT_EQ(csvField("@a,b"), "\"'@a,b\"");
}

TEST(CsvNumber, hasFourPlaces) {
  EXPECT_EQ(csvNumber(0.12345), "0.1235");
  EXPECT_EQ(csvNumber(-0.00001), "0.0000");
  EXPECT_EQ(csvNumber({}), "");
  EXPECT_EQ(csvNumber(HUGE_VAL), "") << "as in JSON, which has no word for it";
  EXPECT_EQ(csvNumber(NAN), "");
}

using Cells = std::vector<std::string>;

TEST(CsvText, columnsAreFoundInLettersOfEitherCase) {
  EXPECT_EQ(columnOf({"Name", "X", "x"}, "x"), 1u);
  EXPECT_EQ(columnOf({"name"}, "x"), std::nullopt);
}

TEST(CsvReader, readsQuotesCommasAndEmptyCells) {
  const std::string text = "name,x,y\r\n\"a, \"\"b\"\"\",1,\n\n" + csvField("c\nd") + ",2,3";
  CsvReader reader(text, "a.csv");
  EXPECT_EQ(reader.nextLine(), (Cells{"name", "x", "y"}));
  EXPECT_EQ(reader.nextLine(), (Cells{"a, \"b\"", "1", ""}));
  EXPECT_EQ(reader.nextLine(), (Cells{""}));
  EXPECT_FALSE(reader.isAtEnd());
  EXPECT_EQ(reader.nextLine(), (Cells{"c\nd", "2", "3"}));
  EXPECT_TRUE(reader.isAtEnd());
  EXPECT_EQ(reader.line(), 4u);
}

TEST(CsvReader, countsLinesAsEditorsDo) {
  const std::string text = "name\n\"a\nb\"\r\n\nc\n";
  CsvReader reader(text, "a.csv");
  for (const std::size_t line : {1u, 2u, 4u, 5u}) {
    reader.nextLine();
    EXPECT_EQ(reader.line(), line);
  }
}

TEST(CsvReader, aQuoteWithoutItsEndIsRefused) {
  const std::string text = "a\n\"b\n\",\"c,d\ne\n";
  CsvReader reader(text, "a.csv");
  reader.nextLine();
  EXPECT_EQ(test::refusalOf([&] { reader.nextLine(); }),
            "a.csv: has a quote not closed in line 3: close it, or take it out");
  EXPECT_TRUE(reader.isAtEnd());
}

TEST(CsvReader, textBehindAQuoteIsRefusedWithItsLineAlone) {
  const std::string text = "\"abc\"def,1,1\n\"a\" ,2\n";
  CsvReader reader(text, "a.csv");
  EXPECT_EQ(test::refusalOf([&] { reader.nextLine(); }),
            "a.csv: has text after a closing quote in line 1: put the whole cell in quotes, and "
            "each quote in it twice");
  EXPECT_EQ(reader.nextLine(), (Cells{"a", "2"}));
  EXPECT_EQ(reader.line(), 2u);
}

}  // namespace

}  // namespace roomgraph
