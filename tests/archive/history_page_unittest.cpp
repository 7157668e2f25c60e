#include "roomgraph/archive/history_page.h"

#include <gtest/gtest.h>

#include "occurrences.h"
#include "sample_nights.h"

namespace roomgraph {
namespace {

using test::has;

WatchedSite siteOf(const std::string& name, double error, int nights = 12) {
  WatchedSite site;
  site.history.site = name;
  for (int night = 0; night < nights; ++night)
    site.history.runs.push_back(test::historyRun("anna", night, error));
  site.watch = watchSite(site.history, {});
  return site;
}

TEST(HistoryPage, theRobotThatNeedsAttentionComesFirst) {
  const std::string page = historyPage({siteOf("good", 0.1), siteOf("bad", 0.5)}, {});
  EXPECT_TRUE(has(page, "<h1>1 robot of 2 needs attention</h1>")) << page.substr(0, 3000);
  EXPECT_LT(page.find("<th scope=\"row\">bad</th>"), page.find("<th scope=\"row\">good</th>"));
  EXPECT_TRUE(has(page, "above the limit of 0.30 m; no good one is known"));
  EXPECT_TRUE(has(page, "2 sites, 2 robots, 24 runs"));
}

TEST(HistoryPage, needsNoOtherFileAndRunsNothing) {
  const std::string page = historyPage({siteOf("office", 0.1)}, {});
  for (const char* part : {"http://", "https://", "<script", "src=", "url("})
    EXPECT_FALSE(has(page, part)) << part;
  EXPECT_TRUE(has(page, "<h1>anna: yes, the map of 1970-01-12 may be rolled out</h1>"));
}

TEST(HistoryPage, whereTheFilesLieIsNobodysBusiness) {
  WatchedSite site = siteOf("office", 0.1);
  for (HistoryRun& run : site.history.runs) run.file = "/disk/runs/" + run.file;
  const std::string page = historyPage({site}, {});
  EXPECT_FALSE(has(page, "/disk"));
  EXPECT_TRUE(has(page, "; 11anna.simplemap</title>")) << "of a mark";
  EXPECT_TRUE(has(page, "<td>11anna.simplemap</td>")) << "in the table";
}

TEST(HistoryPage, whatMayBeWiderThanTheWindowIsReachedByKeyboard) {
  const std::string page = historyPage({siteOf("office", 0.1)}, {});
  for (const std::string part : {"<div class=\"scroll\"", "<div class=\"plot\""}) {
    EXPECT_TRUE(has(page, part + " tabindex=\"0\" role=\"region\" aria-label=")) << part;
    EXPECT_FALSE(has(page, part + ">")) << part;
  }
}

TEST(HistoryPage, aRobotOfFewNightsIsNotCalledSound) {
  const std::string alone = historyPage({siteOf("new", 0.1, 9)}, {});
  EXPECT_TRUE(has(alone, "<td class=\"state unsure\">too few nights</td>"));
  EXPECT_FALSE(has(alone, "as ever"));
  const std::string both = historyPage({siteOf("new", 0.1, 9), siteOf("old", 0.1)}, {});
  const std::string young = historyPage({siteOf("new", 0.1, 9), siteOf("newer", 0.1, 8)}, {});
  EXPECT_TRUE(has(young, "<h1>Too few nights to see a trend</h1>"));
  EXPECT_TRUE(has(both, "<h1>No alarm, but 1 of 2 robots has too few nights to see a trend</h1>"));
  EXPECT_TRUE(has(both, "<td class=\"state\">as ever</td>"));
}

TEST(HistoryPage, aMapThatMayNotBeRolledOutIsTheHeadline) {
  WatchedSite site = siteOf("office", 0.1);
  site.history.runs.push_back(test::historyRun("anna", 12, 3));
  site.watch = watchSite(site.history, {});
  const std::string page = historyPage({site}, {});
  EXPECT_TRUE(has(page,
                  "<h1>anna: no, the map of 1970-01-13 is 3.000 m off, with a limit of 0.3 m: keep "
                  "that of 1970-01-12</h1>"));
  EXPECT_TRUE(has(page, "<td class=\"state bad\">keep the old map</td>"));
}

TEST(HistoryPage, namesAreText) {
  const std::string page = historyPage({siteOf("<script>x</script>", 0.1)}, {});
  EXPECT_FALSE(has(page, "<script"));
  EXPECT_TRUE(has(page, "&lt;script&gt;x"));
}

TEST(HistoryPage, manySitesAreAllInTheTableAndTwentyHavePlots) {
  std::vector<WatchedSite> sites;
  for (int i = 0; i < 25; ++i) sites.push_back(siteOf("site " + std::to_string(i), 0.1));
  const std::string page = historyPage(sites, {});
  EXPECT_TRUE(has(page, "<th scope=\"row\">site 24</th>"));
  EXPECT_TRUE(has(page, "id=\"site19\""));
  EXPECT_FALSE(has(page, "id=\"site20\""));
  EXPECT_TRUE(has(page, "5 more sites are only in the table"));
}

TEST(HistoryPage, anEmptyArchiveHasAPageToo) {
  EXPECT_TRUE(has(historyPage({}, {}), "<h1>No runs yet</h1>"));
}

}  // namespace
}  // namespace roomgraph
