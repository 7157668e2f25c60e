#include "roomgraph/page/comparison_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "occurrences.h"
#include "page_data.h"
#include "roomgraph/report/comparison_json.h"
#include "sample_comparison.h"

namespace roomgraph {
namespace {

using test::count;
using test::kHostileName;
using test::sample;
using test::SampleComparison;
using test::sampleComparison;

std::string report() { return comparisonReport(sample().comparison, sample().runs); }

TEST(ComparisonReport, holdsVerdictRunsRoomsBreaksPairsAndWhatWasLeftOut) {
  const std::string html = report();
  for (const char* text :
       {"morning is the best map", "Kitchen", "garage.gridmap", "split_at_doors",
        "does not lie in the same site as the others", "Leaflet", "Michael Bostock"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
  EXPECT_EQ(count(html, "class=\"room\"") + count(html, "class=\"room same\""), 5u);
  EXPECT_EQ(count(html, "class=\"break\""), 2u);
  EXPECT_EQ(count(html, "data-layer=\"run-"), 4u);
}

TEST(ComparisonReport, countsThePairsOfTheSiteOnly) {
  SampleComparison more = sample();
  for (const roomgraph::Run& run : sample().runs) {
    ComparedPair pair;
    pair.a = "garage", pair.b = run.name;
    more.comparison.pairs.push_back(pair);
  }
  const std::string html = comparisonReport(more.comparison, more.runs);
  EXPECT_NE(html.find("4 runs of one site, 6 pairs, 5 rooms and corridors"), std::string::npos);
  EXPECT_EQ(count(html, ">garage<"), 5u) << "pairs with what is left out are in the table";
}

TEST(ComparisonReport, piecesOfAMapAreNotCalledBreaks) {
  SampleComparison more = sample();
  for (ComparedRun& run : more.comparison.runs)
    run.measures.push_back({"brokenness", 1.5, "pieces", 900, {}, {}, true});
  const std::string html = comparisonReport(more.comparison, more.runs);
  EXPECT_EQ(count(html, ">Extra pieces"), 1u);
  EXPECT_EQ(html.find("[pieces]"), std::string::npos);
}

TEST(ComparisonReport, namesAreTextAndNeverCode) {
  const std::string html = report();
  EXPECT_EQ(html.find("<script>window.struck"), std::string::npos);
  EXPECT_EQ(html.find("<img src=x"), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;window.struck"), std::string::npos);
  EXPECT_EQ(count(html, "</script>"), 5u) << "the document, the pictures and three scripts";
  EXPECT_NE(html.find("&amp;{{x}}"), std::string::npos) << "not taken for a part of the template";
}

TEST(ComparisonReport, asksForNoOtherFile) {
  const std::string html = report();
  EXPECT_EQ(html.find("<link"), std::string::npos);
  EXPECT_EQ(html.find("sourceMappingURL"), std::string::npos);
  EXPECT_EQ(html.find("url(images"), std::string::npos);
  EXPECT_EQ(html.find("@import"), std::string::npos);
  EXPECT_EQ(html.find("<script src"), std::string::npos);
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
}

TEST(ComparisonReport, theOrderOfTheMapsChangesNoByte) {
  SampleComparison other = sampleComparison();
  std::reverse(other.runs.begin(), other.runs.end());
  EXPECT_EQ(comparisonReport(other.comparison, other.runs), report());
}

TEST(ComparisonReport, anEmptyComparisonIsAPage) {
  Comparison nothing;
  nothing.verdict = "No two runs are of the same site: nothing can be compared.";
  const std::string html = comparisonReport(nothing, {});
  EXPECT_NE(html.find("nothing can be compared"), std::string::npos);
  EXPECT_NE(html.find("No rooms are listed"), std::string::npos);
  EXPECT_NE(html.find("No break was found"), std::string::npos);
}

TEST(ComparisonReport, namesNeedNotBeUtf8) {
  SampleComparison broken = sample();
  broken.comparison.runs[0].name = broken.runs[0].name = "caf\xe9";
  const std::string html = comparisonReport(broken.comparison, broken.runs);
  EXPECT_NE(html.find("caf\xef\xbf\xbd"), std::string::npos);
  EXPECT_EQ(html.find("caf\xe9"), std::string::npos);
}

TEST(ComparisonReport, aRunWithoutAMapIsListedButNotDrawn) {
  SampleComparison less = sample();
  less.runs.pop_back();
  const auto data = nlohmann::json::parse(pageData(less.comparison, less.runs));
  ASSERT_EQ(data["runs"].size(), 4u);
  EXPECT_TRUE(data["runs"][3]["picture"].is_null());
  EXPECT_FALSE(data["runs"][2]["picture"].is_null());
}

TEST(ComparisonReport, holdsTheSavedDocument) {
  const std::string html = report(), tag = "id=\"comparison\">";
  const std::size_t begin = html.find(tag) + tag.size();
  const std::string embedded = html.substr(begin, html.find("</script>", begin) - begin);
  EXPECT_EQ(embedded.find_first_of("<>&"), std::string::npos) << "it could end the script";
  const Comparison read = parseComparisonJson(embedded, "report.html");
  EXPECT_EQ(comparisonJson(read), comparisonJson(sample().comparison));
}

TEST(ComparisonReport, atFirstTheBestRunAndTheTornOnesAreShown) {
  const auto shown = [](const Comparison& comparison) {
    const std::string html = comparisonReport(comparison, sample().runs);
    std::string found;
    for (std::size_t i = 0; i < 4; ++i)
      if (html.find("data-layer=\"run-" + std::to_string(i) + "\" checked") != std::string::npos)
        found += std::to_string(i);
    return found;
  };
  Comparison comparison = sample().comparison;
  EXPECT_EQ(shown(comparison), "02");
  comparison.breaks.clear();
  EXPECT_EQ(shown(comparison), "0123");
}

}  // namespace
}  // namespace roomgraph
