#include "roomgraph/archive/history_page.h"

#include <algorithm>

#include "error_plot.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/base/xml_text.h"
#include "roomgraph/page/simple_page.h"

namespace roomgraph {
namespace {

constexpr std::size_t kMostSites = 20;  // with plots

/** A robot in a site. */
struct Row {
  const WatchedSite* site = nullptr;
  const RobotWatch* robot = nullptr;
};

std::string metres(std::optional<double> value) { return value ? formatted("%.3f", *value) : "–"; }

/** The larger, the more it needs attention. */
int needOf(const RobotWatch& robot) {
  if (robot.rollout == Rollout::no || robot.isLost()) return 6;
  if (robot.errors.isOverLimit) return 5;
  if (robot.errors.isDeclining) return 4;
  if (robot.errors.isChanged) return 3;
  if (robot.runs.empty()) return 2;
  return robot.errors.isTooShort ? 1 : 0;
}

const char* stateOf(const RobotWatch& robot) {
  constexpr const char* kStates[] = {"as ever",         "too few nights", "not judged",
                                     "worse since",     "gets worse",     "above limit",
                                     "keep the old map"};
  return kStates[needOf(robot)];
}

std::optional<double> latestError(const Row& row) {
  return trustedValueOf(row.site->history.runs[row.robot->latest].figures, kMapError);
}

std::vector<Row> rowsByNeed(const std::vector<WatchedSite>& sites) {
  std::vector<Row> rows;
  for (const WatchedSite& site : sites)
    for (const RobotWatch& robot : site.watch.robots) rows.push_back({&site, &robot});
  std::stable_sort(rows.begin(), rows.end(), [](const Row& l, const Row& r) {
    const int left = needOf(*l.robot), right = needOf(*r.robot);
    return left != right ? left > right : latestError(l).value_or(0) > latestError(r).value_or(0);
  });
  return rows;
}

/** Where no robot alarms: says so only of those of which enough nights are known. */
std::string calmHeadline(const std::vector<Row>& rows) {
  const auto untold = countIf(rows, [](const Row& row) { return row.robot->errors.isTooShort; });
  if (untold == 0) return "No robot's map gets worse";
  if (untold == rows.size()) return "Too few nights to see a trend";
  return "No alarm, but " + std::to_string(untold) + " of " +
         counted(rows.size(), "robot", "robots") + (untold == 1 ? " has" : " have") +
         " too few nights to see a trend";
}

bool needsAttention(const Row& row) {
  return row.robot->isAlarm() || row.robot->rollout == Rollout::no;
}

std::string headline(const std::vector<Row>& rows) {
  const auto alarms = countIf(rows, needsAttention);
  if (rows.empty()) return "No runs yet";
  if (rows.size() == 1)
    return rows[0].robot->robot + ": " + rows[0].robot->advice +
           (rows[0].robot->isAlarm() ? "; " + rows[0].robot->sentence : "");
  if (alarms == 0) return calmHeadline(rows);
  return counted(alarms, "robot", "robots") + " of " + std::to_string(rows.size()) +
         (alarms == 1 ? " needs attention" : " need attention");
}

std::string rowHtml(const Row& row, const WatchOptions& options) {
  const RobotWatch& robot = *row.robot;
  const auto& runs = row.site->history.runs;
  const char* kind = needsAttention(row) ? " bad" : robot.errors.isTooShort ? " unsure" : "";
  return std::string("<tr><td class=\"state") + kind + "\">" + stateOf(robot) +
         "</td><th scope=\"row\">" + xmlText(row.site->history.site) + "</th><td>" +
         xmlText(robot.robot) + "</td><td>" + errorSparkline(*row.site, robot, options) +
         "</td><td class=\"n\">" + metres(latestError(row)) + "</td><td class=\"n\">" +
         std::to_string(robot.runs.size()) + "</td><td class=\"n\">" +
         dayText(runs[robot.latest].time) + "</td><td class=\"n\">" +
         (robot.lastGood ? dayText(runs[*robot.lastGood].time) : "–") + "</td><td class=\"why\">" +
         xmlText(robot.advice + "; " + robot.sentence) + "</td></tr>\n";
}

std::string robotsHtml(const std::vector<Row>& rows, const WatchOptions& options) {
  std::string html =
      "<section id=\"robots\" aria-labelledby=\"robots-title\">\n<h2 id=\"robots-title\">Robots"
      "</h2>\n<p class=\"hint\">Robots that need attention come first. The map error is how far a "
      "map lies from where the walls are, by all runs together; the limit is " +
      metres(options.limit) +
      " m.</p>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Table of "
      "robots\"><table>\n<thead><tr><th scope=\"col\">State</th><th "
      "scope=\"col\">Site</th><th scope=\"col\">Robot</th><th scope=\"col\">Map error over "
      "time</th><th scope=\"col\" class=\"n\">Latest [m]</th><th scope=\"col\" "
      "class=\"n\">Nights</th><th scope=\"col\" class=\"n\">Latest run</th><th scope=\"col\" "
      "class=\"n\">Last good</th><th scope=\"col\">What is seen</th></tr></thead>\n<tbody>\n";
  for (const Row& row : rows) html += rowHtml(row, options);
  return html + "</tbody></table></div>\n</section>\n";
}

std::string runsHtml(const SiteHistory& history) {
  std::string html =
      "<details><summary>Latest runs</summary><div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"Table of runs\"><table><thead><tr><th "
      "scope=\"col\">Time</th><th scope=\"col\">Robot</th><th scope=\"col\" class=\"n\">Map error "
      "[m]</th><th scope=\"col\">File</th><th scope=\"col\">Why</th></tr></thead><tbody>\n";
  const std::size_t count = std::min<std::size_t>(15, history.runs.size());
  for (std::size_t i = 0; i < count; ++i) {
    const HistoryRun& run = history.runs[history.runs.size() - 1 - i];
    html += "<tr><td>" + timeText(run.time) + "</td><td>" + xmlText(run.robot) +
            "</td><td class=\"n\">" + metres(trustedValueOf(run.figures, kMapError)) + "</td><td>" +
            xmlText(fileName(run.file)) + "</td><td class=\"why\">" + xmlText(run.reason) +
            "</td></tr>\n";
  }
  return html + "</tbody></table></div></details>\n";
}

std::string siteHtml(const WatchedSite& site, std::size_t number, const WatchOptions& options) {
  const std::string id = "site" + std::to_string(number);
  std::string html = "<section class=\"plots\" id=\"" + id + "\" aria-labelledby=\"" + id +
                     "-title\">\n<h2 id=\"" + id + "-title\">" + xmlText(site.history.site) +
                     "</h2>\n";
  for (const RobotWatch& robot : site.watch.robots)
    html += "<h3>" + xmlText(robot.robot) + ": " + xmlText(robot.sentence) +
            "</h3>\n<div class=\"plot\" tabindex=\"0\" role=\"region\" aria-label=\"Plot of map "
            "errors\">" +
            errorPlot(site, robot, options) + "</div>\n";
  if (!site.watch.changes.empty()) {
    html += "<h3>Rooms that have changed for good</h3>\n<ul>\n";
    for (const RoomChange& change : site.watch.changes)
      html += "<li>" + xmlText(changeText(change, site.history)) + "</li>\n";
    html += "</ul>\n";
  }
  return html + runsHtml(site.history) + "</section>\n";
}

/** The sites in the order of the robot of each that needs attention most. */
std::string sitesHtml(const std::vector<Row>& rows, const WatchOptions& options) {
  std::vector<const WatchedSite*> sites;
  for (const Row& row : rows)
    if (!contains(sites, row.site)) sites.push_back(row.site);
  std::string html =
      "<p class=\"hint\">A dot is a run, its line holds the true error in about 8 of 10 cases; a "
      "cross is a map with a break, a triangle one that lies beyond the picture, the ring the last "
      "good one. Point at a mark for its file.</p>\n";
  for (std::size_t i = 0; i < std::min(kMostSites, sites.size()); ++i)
    html += siteHtml(*sites[i], i, options);
  if (sites.size() > kMostSites)
    html += "<p class=\"none\">" +
            counted(sites.size() - kMostSites, "more site is", "more sites are") +
            " only in the table; 'roomgraph archive ARCHIVE report --site NAME' makes the page of "
            "a site.</p>\n";
  return html;
}

}  // namespace

std::string historyPage(const std::vector<WatchedSite>& sites, const WatchOptions& options) {
  const std::vector<Row> rows = rowsByNeed(sites);
  std::size_t runs = 0;
  for (const WatchedSite& site : sites) runs += site.history.runs.size();
  SimplePage page;
  page.title = (sites.size() == 1 ? xmlText(sites[0].history.site) : "Sites") + " over time";
  page.subject = "maps over time", page.heading = xmlText(headline(rows));
  page.counts = counted(sites.size(), "site", "sites") + ", " +
                counted(rows.size(), "robot", "robots") + ", " + counted(runs, "run", "runs");
  page.style =
      ".plots h3{margin-top:22px} .state{font-weight:650;white-space:nowrap} "
      ".state.bad{color:var(--alarm)} .state.unsure{color:var(--soft);font-weight:400} "
      "@media screen and (max-width:700px){.plot{overflow-x:auto} .plot svg{max-width:none}}";
  page.body = robotsHtml(rows, options) + sitesHtml(rows, options);
  page.footer = "roomgraph's docs/archive.md explains the alarms.";
  return simplePage(page);
}

}  // namespace roomgraph
