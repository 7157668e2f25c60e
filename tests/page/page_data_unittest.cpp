#include "page_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "sample_comparison.h"

namespace roomgraph {
namespace {

using test::sample;

TEST(PageData, isJsonThatCannotEndAScript) {
  const std::string text = pageData(sample().comparison, sample().runs);
  EXPECT_EQ(text.find_first_of("<>&"), std::string::npos);
  const auto data = nlohmann::json::parse(text);
  EXPECT_EQ(data["runs"][2]["colour"], colourText(2));
  EXPECT_FALSE(data["heat"].is_null()) << "the third run has another wall";
}

TEST(PageData, allRunsOfOneBuildingLieInOnePlace) {
  const auto data = nlohmann::json::parse(pageData(sample().comparison, sample().runs));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto box = data["runs"][i]["picture"]["box"];
    EXPECT_NEAR(box[0][0].get<double>(), 0, 0.4) << i;
    EXPECT_NEAR(box[0][1].get<double>(), 0, 0.7) << i;
    EXPECT_NEAR(box[1][1].get<double>(), 12, 0.9) << i;
  }
}

TEST(PageData, aBreakOfARunWithScansHasThem) {
  const auto data = nlohmann::json::parse(pageData(sample().comparison, sample().runs));
  ASSERT_EQ(data["breaks"].size(), sample().comparison.breaks.size());
  EXPECT_NE(data["breaks"][0], data["breaks"][1]) << "the second has no key frame";
}

TEST(PageData, wallsThatNoOtherRunHasAreMarkedWhereTheyAreTooMany) {
  Comparison comparison = sample().comparison;
  Measure added;
  added.name = "walls_added";
  added.isMeaningful = true, added.place = Point{1, 2};
  for (const double share : {kMostAdded - 0.01, kMostAdded + 0.01}) {
    added.value = share;
    comparison.runs[1].measures = {added};
    const auto data = nlohmann::json::parse(pageData(comparison, sample().runs));
    EXPECT_TRUE(data["runs"][0]["added"].is_null());
    EXPECT_EQ(data["runs"][1]["added"],
              share > kMostAdded ? nlohmann::json({1, 2}) : nlohmann::json());
  }
}

TEST(PageData, ofNoRunsThereIsNothingToDraw) {
  const auto data = nlohmann::json::parse(pageData({}, {}));
  EXPECT_TRUE(data["runs"].empty());
  EXPECT_TRUE(data["breaks"].empty());
  EXPECT_TRUE(data["heat"].is_null());
}

TEST(PageDocument, cannotEndAScript) {
  const std::string text = pageDocument(sample().comparison);
  EXPECT_EQ(text.find_first_of("<>&"), std::string::npos);
  const auto document = nlohmann::json::parse(text);
  EXPECT_EQ(document["runs"][2]["name"], test::kHostileName) << "and is the same text all the same";
}

TEST(ColourText, isAColourAsPagesHaveIt) {
  std::set<std::string> colours;
  for (std::size_t run = 0; run < 6; ++run) {
    const std::string text = colourText(run);
    ASSERT_EQ(text.size(), 7u);
    EXPECT_EQ(text[0], '#');
    EXPECT_EQ(text.find_first_not_of("0123456789abcdef", 1), std::string::npos) << text;
    colours.insert(text);
  }
  EXPECT_EQ(colours.size(), 6u);
}

TEST(FixedText, hasSoManyDigitsAndADashForNothing) {
  EXPECT_EQ(fixedText(1.005, 1), "1.0");
  EXPECT_EQ(fixedText(-0.04, 1), "-0.0");
  EXPECT_EQ(fixedText(-0.0, 0), "0");
  EXPECT_EQ(fixedText(12.345, 2), "12.35");
  for (const auto& none :
       {std::optional<double>(), std::optional<double>(HUGE_VAL), std::optional<double>(NAN)})
    EXPECT_EQ(fixedText(none, 2), "–");
  EXPECT_EQ(fixedText(1e300, 0).size(), 59u) << "cut, and not beyond its place";
}

TEST(PercentText, isOfAHundred) {
  EXPECT_EQ(percentText(0.1), "10 %");
  EXPECT_EQ(percentText(1), "100 %");
  EXPECT_EQ(percentText(NAN), "– %");
}

TEST(BreakScans, areThoseOnEitherSideInTheFrameOfTheSite) {
  const auto sample = test::sampleComparison();
  const BreakScans scans =
      breakScans(sample.comparison, faultsOf(sample.comparison)[0], sample.runs);
  ASSERT_FALSE(scans.before.empty() || scans.behind.empty());
  for (const auto* places : {&scans.before, &scans.behind}) {
    EXPECT_LE(places->size(), 250u);
    for (const Point p : *places) EXPECT_NEAR(std::abs(p.y - 6), 0.8, 1e-9) << "a wall of the hall";
  }
  // Key frame 12 stands at x = 9.5; a scan reaches 1 m to either side.
  for (const Point p : scans.before) EXPECT_LT(p.x, 9.5 - 0.75 + 1.01);
  for (const Point p : scans.behind) EXPECT_GT(p.x, 9.5 - 1.01);
}

TEST(BreakScans, aRunWithoutScansOrMapHasNone) {
  const auto sample = test::sampleComparison();
  const std::vector<Fault> faults = faultsOf(sample.comparison);
  EXPECT_TRUE(breakScans(sample.comparison, faults[1], sample.runs).behind.empty())
      << "no key frame";
  EXPECT_TRUE(breakScans(sample.comparison, faults[0], {}).before.empty());
}

TEST(Base64, isThatOfTheStandard) {
  // The examples of RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, takesAnyByte) { EXPECT_EQ(base64(std::string("\xff\xef\0\x80", 4)), "/+8AgA=="); }

}  // namespace
}  // namespace roomgraph
