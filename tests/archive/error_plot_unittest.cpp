#include "error_plot.h"

#include <gtest/gtest.h>

#include "occurrences.h"
#include "sample_nights.h"

namespace roomgraph {
namespace {

using test::count;

WatchedSite siteOf(const std::vector<double>& errors) {
  WatchedSite site;
  for (const double error : errors)
    site.history.runs.push_back(test::historyRun("anna", int(site.history.runs.size()), error));
  site.watch = watchSite(site.history, {});
  return site;
}

std::string plotOf(const WatchedSite& site) {
  return errorPlot(site, site.watch.robots.front(), {});
}

TEST(ErrorPlot, hasAMarkForEachRunAndARingForTheLastGoodOne) {
  WatchedSite site = siteOf({0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.2, 5});
  const std::string plot = plotOf(site);
  EXPECT_EQ(count(plot, "<title>"), 11U);
  EXPECT_EQ(count(plot, "r=\"3.5\""), 10U);
  EXPECT_EQ(count(plot, "l5 9h-10z"), 1U);  // far above the others
  EXPECT_EQ(count(plot, "r=\"8\""), 1U);
  EXPECT_EQ(count(plot, ">limit<"), 1U);
  EXPECT_EQ(count(plot, "worse since"), 0U);
}

TEST(ErrorPlot, hasAnEndForARunOfATimeThatIsNone) {
  WatchedSite site = siteOf({0.1, 0.1});
  site.history.runs.back().time = 1e300;
  EXPECT_LE(count(plotOf(site), "text-anchor=\"middle\""), 7U);
}

TEST(ErrorPlot, marksTornRunsAndTheChange) {
  WatchedSite site = siteOf(std::vector<double>(20, 0.1));
  for (int night = 0; night < 20; ++night)
    site.history.runs.push_back(test::historyRun("anna", 20 + night, 0.2));
  site.history.runs[3].figures.push_back(site.history.runs[3].figures[0]);
  site.history.runs[3].figures.back().name = kBreaks;
  site.watch = watchSite(site.history, {});
  const std::string plot = plotOf(site);
  EXPECT_EQ(count(plot, "m0 -8l-8 8"), 1U);
  EXPECT_EQ(count(plot, "worse since"), 1U);
}

TEST(ErrorPlot, oneRunIsEnoughAndNoneGivesNothing) {
  EXPECT_EQ(count(plotOf(siteOf({0.1})), "<title>"), 1U);
  EXPECT_EQ(plotOf(siteOf({0.1})).find("nan"), std::string::npos);
  WatchedSite site = siteOf({0.1});
  site.history.runs[0].figures.clear();
  site.watch = watchSite(site.history, {});
  EXPECT_EQ(plotOf(site), "");
  EXPECT_EQ(errorSparkline(site, site.watch.robots.front(), {}), "");
}

TEST(ErrorPlot, errorsOfNoughtHaveAPlaceToo) {
  EXPECT_EQ(plotOf(siteOf({0, 0, 0})).find("nan"), std::string::npos);
}

TEST(ErrorSparkline, isALineThroughAllRuns) {
  const WatchedSite site = siteOf({0.1, 0.2, 0.3});
  const std::string line = errorSparkline(site, site.watch.robots.front(), {});
  EXPECT_EQ(count(line, ","), 3U) << line;
  EXPECT_EQ(count(line, "<circle"), 0U);
}

TEST(ErrorSparkline, isADotOfASingleRun) {
  const WatchedSite site = siteOf({0.1});
  const std::string dot = errorSparkline(site, site.watch.robots.front(), {});
  EXPECT_EQ(count(dot, "<circle"), 1U) << dot;
  EXPECT_EQ(dot.find("nan"), std::string::npos) << dot;
}

}  // namespace
}  // namespace roomgraph
