#include <gtest/gtest.h>

#include "page_summary.h"
#include "sample_comparison.h"

namespace roomgraph {
namespace {

TEST(BareReport, holdsTheVerdictWhatStandsOutAndWhatIsMissing) {
  const std::string html = bareReport(test::sample().comparison);
  for (const char* text : {"morning is the best map", "<li>Why morning: ", "4 runs of one site",
                           "built without mustache, Leaflet and D3"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
}

TEST(BareReport, showsHostileNamesAsText) {
  const std::string html = bareReport(test::sample().comparison);
  EXPECT_EQ(html.find(test::kHostileName), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
}

}  // namespace
}  // namespace roomgraph
