#include "roomgraph/archive/export_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "sample_nights.h"
#include "schemas.h"

namespace roomgraph {
namespace {

std::vector<WatchedSite> oneSite() {
  WatchedSite site;
  site.history.site = "office \"A\"";
  for (int n = 0; n < 12; ++n) site.history.runs.push_back(test::historyRun("anna", n, 0.1));
  site.history.runs.push_back(test::historyRun("=berta", 12, 0.5));
  site.history.runs.back().isPlaced = false;
  site.history.runs.back().figures.clear();
  site.watch = watchSite(site.history, {});
  return {site};
}

TEST(ExportHistory, csvHasALinePerRunAndAsManyFieldsInEach) {
  const std::string text = historyCsv(oneSite());
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 14);
  EXPECT_NE(text.find("anna,1970-01-02T00:00:00Z,1anna.simplemap,1anna,placed,0.1000,0.0500,0.2000"
                      ",1,,,"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("'=berta"), std::string::npos);
  EXPECT_NE(text.find("other site,,,,0"), std::string::npos);
  std::size_t begin = 0, commas = std::string::npos;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    const auto count = std::size_t(
        std::count(text.begin() + std::ptrdiff_t(begin), text.begin() + std::ptrdiff_t(end), ','));
    if (commas == std::string::npos) commas = count;
    EXPECT_EQ(count, commas);
    begin = end + 1;
  }
}

TEST(ExportHistory, jsonHasAllOfIt) {
  const auto json = nlohmann::json::parse(historyJson(oneSite()));
  EXPECT_EQ(json["format"], "roomgraph/archive");
  const auto& site = json["sites"][0];
  EXPECT_EQ(site["site"], "office \"A\"");
  EXPECT_EQ(site["runs"].size(), 13U);
  EXPECT_EQ(site["runs"][0]["figures"]["map_error_m"]["value"], 0.1);
  EXPECT_EQ(site["robots"].size(), 2U);
  EXPECT_EQ(site["robots"][1]["judged_runs"], 12);
  EXPECT_EQ(site["robots"][0]["too_few_nights"], true);
  EXPECT_EQ(site["robots"][1]["too_few_nights"], false);
  EXPECT_EQ(site["robots"][1]["last_good"]["sha256"], "11anna");
  EXPECT_TRUE(site["robots"][0]["last_good"].is_null());
}

TEST(ExportHistory, jsonFollowsTheSchema) {
  std::vector<WatchedSite> sites = oneSite();
  SiteHistory& history = sites[0].history;
  RoomSeen room;
  room.room = "R1";
  history.runs[0].rooms = {room};
  sites[0].watch.changes = {{"R1", "doors", 0, 3, 2}};
  history.ledger.rooms.emplace_back();
  EXPECT_EQ(test::schemaComplaint("archive", historyJson(sites)), "");
}

TEST(ExportHistory, prometheusHasEachGaugeOnceWithItsHelp) {
  const std::string text = historyPrometheus(oneSite());
  EXPECT_NE(text.find("roomgraph_map_error_metres{site=\"office \\\"A\\\"\",robot=\"anna\"} 0.1\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("roomgraph_over_limit{site=\"office \\\"A\\\"\",robot=\"anna\"} 0\n"),
            std::string::npos);
  EXPECT_NE(text.find("roomgraph_too_few_nights{site=\"office \\\"A\\\"\",robot=\"anna\"} 0\n"),
            std::string::npos);
  EXPECT_NE(text.find("roomgraph_too_few_nights{site=\"office \\\"A\\\"\",robot=\"=berta\"} 1\n"),
            std::string::npos);
  EXPECT_EQ(text.find("roomgraph_map_error_metres{site=\"office \\\"A\\\"\",robot=\"=berta\"}"),
            std::string::npos);
  EXPECT_NE(text.find("roomgraph_may_roll_out{site=\"office \\\"A\\\"\",robot=\"anna\"} 1\n"),
            std::string::npos);
  EXPECT_NE(text.find("roomgraph_may_roll_out{site=\"office \\\"A\\\"\",robot=\"=berta\"} 0\n"),
            std::string::npos);
  EXPECT_NE(text.find("# TYPE roomgraph_declining gauge\n"), std::string::npos);
}

TEST(ExportHistory, textHasALinePerRobot) {
  const std::string text = historyText(oneSite()[0]);
  EXPECT_NE(text.find("  anna: yes, the map of 1970-01-12 may be rolled out; its map is as good "
                      "as ever\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("  =berta: no, the map of 1970-01-13 fits no other map of the site, and no "
                      "good one is known; no run of it can be judged yet\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.rfind("office \"A\": 13 runs\n", 0), 0u) << text;
  WatchedSite young;
  young.history.site = "lab";
  young.history.runs.emplace_back();
  EXPECT_EQ(historyText(young), "lab: 1 run\n");
}

TEST(ExportHistory, namesCannotBreakOutOfALabel) {
  std::vector<WatchedSite> sites = oneSite();
  sites[0].history.site = "a\"}\nb\\";
  const std::string text = historyPrometheus(sites);
  EXPECT_NE(text.find("{site=\"a\\\"}\\nb\\\\\",robot=\"anna\"}"), std::string::npos) << text;
  std::size_t begin = 0;
  while (begin < text.size()) {  // each line is a comment or a gauge
    const std::size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    EXPECT_TRUE(line.rfind("# ", 0) == 0 || line.rfind("roomgraph_", 0) == 0) << line;
    begin = end + 1;
  }
}

TEST(ExportHistory, numbersThatAreNoneAreLeftOut) {
  std::vector<WatchedSite> sites = oneSite();
  for (HistoryRun& run : sites[0].history.runs)
    for (Measure& figure : run.figures) figure.value = HUGE_VAL, figure.high = NAN;
  const auto json = nlohmann::json::parse(historyJson(sites));
  EXPECT_TRUE(json["sites"][0]["runs"][0]["figures"]["map_error_m"]["value"].is_null());
  EXPECT_TRUE(json["sites"][0]["runs"][0]["figures"]["map_error_m"]["high"].is_null());
  EXPECT_EQ(historyPrometheus(sites).find("roomgraph_map_error_metres{"), std::string::npos);
  EXPECT_EQ(historyCsv(sites).find("inf"), std::string::npos);
}

TEST(ExportHistory, textThatIsNotUtf8IsStillJson) {
  std::vector<WatchedSite> sites = oneSite();
  sites[0].history.site =
      "b\xfc"
      "ro";
  sites[0].history.runs[0].robot = "\xff\xfe";
  const auto json = nlohmann::json::parse(historyJson(sites));
  EXPECT_EQ(json["sites"].size(), 1U);
}

TEST(ExportHistory, ofNoSitesThereIsAHeadAndNoMore) {
  const std::string csv = historyCsv({});
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1);
  EXPECT_TRUE(nlohmann::json::parse(historyJson({}))["sites"].empty());
  const std::string gauges = historyPrometheus({});
  EXPECT_EQ(gauges.find("{site="), std::string::npos);
}

TEST(ExportHistory, eachGaugeHasItsHelpAndItsTypeOnce) {
  const std::string text = historyPrometheus(oneSite());
  std::istringstream lines(text);
  std::map<std::string, int> helps, types;
  std::set<std::string> used;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first, kind, name;
    words >> first >> kind >> name;
    if (first != "#") used.insert(line.substr(0, line.find('{')));
    if (kind == "HELP") ++helps[name];
    if (kind == "TYPE") ++types[name];
  }
  EXPECT_EQ(helps, types);
  for (const auto& [name, count] : helps) EXPECT_EQ(count, 1) << name;
  for (const std::string& name : used) EXPECT_EQ(helps.count(name), 1U) << name;
  EXPECT_GT(used.size(), 5U);
}

TEST(ExportHistory, aChangeOfARoomIsToldInTextAndJson) {
  std::vector<WatchedSite> sites = oneSite();
  sites[0].watch.changes = {{"R1", "doors", 0, 3, 2}};
  EXPECT_NE(historyText(sites[0]).find("  R1: 2 doors instead of 3 since 1970-01-01\n"),
            std::string::npos);
  const auto json = nlohmann::json::parse(historyJson(sites));
  const auto& change = json["sites"][0]["changes"][0];
  EXPECT_EQ(change["room"], "R1");
  EXPECT_EQ(change["before"], 3);
  EXPECT_EQ(change["since"], "1970-01-01T00:00:00Z");
}

}  // namespace
}  // namespace roomgraph
