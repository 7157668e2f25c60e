#include "roomgraph/archive/export_history.h"

#include <cmath>
#include <functional>

#include "roomgraph/base/Json.h"
#include "roomgraph/base/csv_text.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/base/utf8_text.h"
#include "roomgraph/measures/measure_kinds.h"
#include "roomgraph/report/json_parts.h"

namespace roomgraph {
namespace {

Json lineJson(const std::string& file) {
  return {{"format", "roomgraph/watch"}, {"version", 1}, {"file", file}};
}

std::string csvLine(const std::string& site, const HistoryRun& run) {
  std::string line = csvField(site) + "," + csvField(run.robot) + "," + timeText(run.time) + "," +
                     csvField(run.file) + "," + run.sha256 + "," +
                     (run.isPlaced ? "placed" : "other site");
  const Measure* known = find(run.figures, kMapError);
  const Measure error = known ? *known : Measure();
  for (const auto& value : {error.value, error.low, error.high}) line += "," + csvNumber(value);
  line += error.isMeaningful ? ",1" : ",0";
  for (const char* name : {kScore, kBreaks}) line += "," + csvNumber(valueOf(run.figures, name));
  for (const MeasureKind& kind : runMeasureKinds())
    line += "," + csvNumber(valueOf(run.figures, kind.name));
  return line + "," + csvField(run.reason) + "\n";
}

Json roomJson(const RoomSeen& room) {
  return {{"room", room.room},
          {"sighting", nameOf(room.sighting)},
          {"pieces", room.pieces},
          {"merged", room.isMerged},
          {"doors", room.doors},
          {"area_m2", numberOrNull(room.area)},
          {"shift_m", numberOrNull(room.shift)},
          {"boundary_agreement", numberOrNull(room.boundaryAgreement)}};
}

Json runJson(const HistoryRun& run) {
  return {{"robot", utf8Text(run.robot)},
          {"time", timeText(run.time)},
          {"file", utf8Text(run.file)},
          {"sha256", run.sha256},
          {"placed", run.isPlaced},
          {"reason", utf8Text(run.reason)},
          {"version", run.version},
          {"figures", measuresJson(run.figures)},
          {"rooms", mapped(run.rooms, roomJson)}};
}

Json runOrNull(const SiteHistory& history, std::optional<std::size_t> run) {
  if (!run) return nullptr;
  return {{"time", timeText(history.runs[*run].time)},
          {"file", utf8Text(history.runs[*run].file)},
          {"sha256", history.runs[*run].sha256}};
}

/** Null where nobody knows yet. */
Json mayRollOut(const RobotWatch& robot) {
  return robot.rollout == Rollout::unknown ? Json(nullptr) : Json(robot.rollout == Rollout::yes);
}

Json robotJson(const RobotWatch& robot, const SiteHistory& history) {
  const ErrorWatch& errors = robot.errors;
  Json change = nullptr;
  if (errors.change)
    change = {{"time", timeText(history.runs[robot.runs[errors.change->first]].time)},
              {"before_m", numberOrNull(errors.change->before)},
              {"after_m", numberOrNull(errors.change->after)},
              {"p", errors.change->p}};
  return {{"robot", utf8Text(robot.robot)},
          {"judged_runs", robot.runs.size()},
          {"may_roll_out", mayRollOut(robot)},
          {"advice", utf8Text(robot.advice)},
          {"unjudged_nights", robot.unjudged},
          {"alarm", robot.isAlarm()},
          {"over_limit", errors.isOverLimit},
          {"declining", errors.isDeclining},
          {"changed", errors.isChanged},
          {"too_few_nights", errors.isTooShort},
          {"slope_m_per_day", errors.slope ? Json(errors.slope->perDay) : Json(nullptr)},
          {"p_rising", errors.pRising},
          {"days_to_limit", numberOrNull(errors.daysToLimit)},
          {"change", change},
          {"last_good", runOrNull(history, robot.lastGood)},
          {"sentence", utf8Text(robot.sentence)}};
}

Json knownRoomJson(const SiteRoom& room) {
  return {{"id", room.id}, {"name", utf8Text(room.name)}, {"area_m2", numberOrNull(room.area)}};
}

Json watchedSiteJson(const WatchedSite& site) {
  const SiteHistory& history = site.history;
  const auto robot = [&](const RobotWatch& of) { return robotJson(of, history); };
  const auto change = [&](const RoomChange& of) {
    return Json{{"room", of.room},
                {"what", of.what},
                {"since", timeText(history.runs[of.run].time)},
                {"before", numberOrNull(of.before)},
                {"after", numberOrNull(of.after)}};
  };
  return {{"site", utf8Text(history.site)},
          {"robots", mapped(site.watch.robots, robot)},
          {"changes", mapped(site.watch.changes, change)},
          {"rooms", mapped(history.ledger.rooms, knownRoomJson)},
          {"runs", mapped(history.runs, runJson)}};
}

/** As a label's value in Prometheus' text format. */
std::string quoted(const std::string& given) {
  std::string text = "\"";
  for (const char c : utf8Text(given)) {
    if (c == '\\' || c == '"') text += '\\';
    text += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return text + "\"";
}

/** Of a robot in a site, or nothing. */
using Gauge = std::function<std::optional<double>(const SiteHistory&, const RobotWatch&)>;

struct GaugeKind {
  const char *name, *help;
  Gauge value;
};

Gauge latestFigure(const char* name) {
  return [name](const SiteHistory& history, const RobotWatch& robot) {
    return trustedValueOf(history.runs[robot.latest].figures, name);
  };
}

Gauge flag(bool ErrorWatch::*member) {
  return [member](const SiteHistory&, const RobotWatch& robot) { return robot.errors.*member; };
}

const std::vector<GaugeKind>& gauges() {
  static const std::vector<GaugeKind> all{
      {"roomgraph_may_roll_out", "1 where the latest map may be rolled out, 0 where it may not.",
       [](const SiteHistory&, const RobotWatch& robot) -> std::optional<double> {
         if (robot.rollout == Rollout::unknown) return {};
         return robot.rollout == Rollout::yes;
       }},
      {"roomgraph_unjudged_nights", "Latest runs in a row that tell nothing of the site.",
       [](const SiteHistory&, const RobotWatch& robot) { return double(robot.unjudged); }},
      {"roomgraph_map_error_metres", "How far the latest map lies from where the walls are.",
       latestFigure(kMapError)},
      {"roomgraph_score", "Score of the latest map, 0 to 100.", latestFigure(kScore)},
      {"roomgraph_breaks", "Places where the latest map breaks, slight breaks left out.",
       latestFigure(kBreaks)},
      {"roomgraph_coverage", "Share of the site that the latest map shows.",
       latestFigure("coverage")},
      {"roomgraph_map_error_slope_metres_per_day", "How fast the map error rises.",
       [](const SiteHistory&, const RobotWatch& robot) -> std::optional<double> {
         if (!robot.errors.slope) return {};
         return robot.errors.slope->perDay;
       }},
      {"roomgraph_over_limit", "1 where the map error is above the limit.",
       flag(&ErrorWatch::isOverLimit)},
      {"roomgraph_declining", "1 where maps get worse and worse.", flag(&ErrorWatch::isDeclining)},
      {"roomgraph_changed", "1 where maps have been worse since some night.",
       flag(&ErrorWatch::isChanged)},
      {"roomgraph_too_few_nights", "1 where too few maps are judged to see whether they get worse.",
       flag(&ErrorWatch::isTooShort)},
      {"roomgraph_judged_runs", "Runs whose map error can be trusted.",
       [](const SiteHistory&, const RobotWatch& robot) { return double(robot.runs.size()); }},
      {"roomgraph_latest_run_timestamp_seconds", "Time of the latest run, judged or not.",
       [](const SiteHistory& history, const RobotWatch& robot) {
         return history.runs[robot.latest].time;
       }},
      {"roomgraph_last_good_run_timestamp_seconds", "Time of the last map that is good enough.",
       [](const SiteHistory& history, const RobotWatch& robot) -> std::optional<double> {
         if (!robot.lastGood) return {};
         return history.runs[*robot.lastGood].time;
       }}};
  return all;
}

}  // namespace

std::string addedRunJson(const std::string& file, const AddedRun& run, const RobotWatch* robot) {
  const auto figure = [&](double RunScore::*member) {
    return run.score ? numberOrNull((*run.score).*member) : Json(nullptr);
  };
  Json json = lineJson(file);
  json["error"] = nullptr;
  json["placed"] = run.isPlaced;
  json["map_error_m"] = figure(&RunScore::mapError);
  json["map_error_low"] = figure(&RunScore::errorLow);
  json["map_error_high"] = figure(&RunScore::errorHigh);
  json["score"] = figure(&RunScore::score);
  json["meaningful"] = run.score && run.score->isMeaningful;
  json["reason"] = run.reason;
  json["may_roll_out"] = robot ? mayRollOut(*robot) : Json(nullptr);
  json["advice"] = robot ? Json(robot->advice) : Json(nullptr);
  json["alarm"] = robot && robot->isAlarm();
  json["robot_says"] = robot ? Json(robot->sentence) : Json(nullptr);
  return lineOf(json);
}

std::string failedRunJson(const std::string& file, const std::string& error) {
  Json json = lineJson(file);
  json["error"] = error;
  return lineOf(json);
}

std::string historyCsv(const std::vector<WatchedSite>& sites) {
  std::string text =
      "site,robot,time,file,sha256,state,map_error_m,map_error_low,map_error_high,meaningful,"
      "score,breaks";
  for (const MeasureKind& kind : runMeasureKinds()) text += std::string(",") + kind.name;
  text += ",reason\n";
  for (const WatchedSite& site : sites)
    for (const HistoryRun& run : site.history.runs) text += csvLine(site.history.site, run);
  return text;
}

std::string historyJson(const std::vector<WatchedSite>& sites) {
  const Json json = {{"format", "roomgraph/archive"},
                     {"version", 1},
                     {"program", programJson()},
                     {"sites", mapped(sites, watchedSiteJson)}};
  return json.dump(1) + "\n";
}

std::string historyPrometheus(const std::vector<WatchedSite>& sites) {
  std::string text;
  for (const GaugeKind& gauge : gauges()) {
    text += std::string("# HELP ") + gauge.name + " " + gauge.help + "\n# TYPE " + gauge.name +
            " gauge\n";
    for (const WatchedSite& site : sites)
      for (const RobotWatch& robot : site.watch.robots) {
        const auto value = gauge.value(site.history, robot);
        if (!value || !std::isfinite(*value)) continue;
        text += std::string(gauge.name) + "{site=" + quoted(site.history.site) +
                ",robot=" + quoted(robot.robot) + formatted("} %.10g\n", *value);
      }
  }
  return text;
}

std::string historyText(const WatchedSite& site) {
  std::string text =
      printable(site.history.site) + ": " + counted(site.history.runs.size(), "run", "runs") + "\n";
  for (const RobotWatch& robot : site.watch.robots)
    text += "  " + printable(robot.robot) + ": " + printable(robot.advice) + "; " +
            printable(robot.sentence) + "\n";
  for (const RoomChange& change : site.watch.changes)
    text += "  " + printable(changeText(change, site.history)) + "\n";
  return text;
}

}  // namespace roomgraph
