#include "roomgraph/archive/watch_site.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/compare/gate.h"
#include "roomgraph/map_files/map_formats.h"

namespace roomgraph {
namespace {

/** Some values on end, and how many of them lie off their median. */
struct Level {
  double value = 0;
  std::size_t off = 0, count = 0;
};

Level levelOf(const std::vector<double>& values, std::size_t begin, std::size_t end,
              double tolerance) {
  const auto at = [&](std::size_t i) { return values.begin() + std::ptrdiff_t(i); };
  Level level;
  level.value = median({at(begin), at(end)});
  level.count = end - begin;
  for (auto value = at(begin); value != at(end); ++value)
    if (std::abs(*value - level.value) > tolerance / 2) ++level.off;
  return level;
}

bool isSteady(const Level& level) { return 4 * level.off <= level.count; }

bool isTorn(const HistoryRun& run) { return trustedValueOf(run.figures, kBreaks).value_or(0) > 0; }

/** The median `wall_sharpness` of the maps that were judged; none of too few. */
std::optional<double> usualSharpness(const SiteHistory& history) {
  std::vector<double> all;
  for (const HistoryRun& run : history.runs)
    if (const auto value =
            run.isPlaced ? trustedValueOf(run.figures, "wall_sharpness") : std::nullopt)
      all.push_back(*value);
  return all.size() > 2 ? std::optional(median(all)) : std::nullopt;
}

/** What is wrong with a map that was judged; empty for nothing. */
std::string mapFault(const HistoryRun& run, std::optional<double> usual,
                     const WatchOptions& options) {
  const auto figure = [&](const char* name) {
    return trustedValueOf(run.figures, name).value_or(0);
  };
  const double breaks = figure(kBreaks), error = figure(kMapError);
  const double seen = trustedValueOf(run.figures, "coverage").value_or(1);
  if (breaks > 0)
    return formatted(breaks == 1 ? "breaks in %.0f place" : "breaks in %.0f places", breaks);
  if (error > options.limit)
    return formatted("is %.3f m off, with a limit of %.4g m", error, options.limit);
  if (seen < kNearlyAll) return formatted("shows only %.0f %% of the site", 100 * seen);
  const double confirmed = trustedValueOf(run.figures, "confirmed").value_or(1);
  if (std::string fault = unconfirmedFault(confirmed, figure("contradicted"), seen); !fault.empty())
    return fault;
  if (figure("walls_missing") > kMostMissing)
    return formatted("lacks %.0f %% of the walls that others have", 100 * figure("walls_missing"));
  if (figure("walls_added") > kMostAdded)
    return formatted("has a place where %.0f %% of the walls stand in free space of the others",
                     100 * figure("walls_added"));
  if (figure("straight_walls_added") > kMostStraightAdded)
    return formatted(
        "has a place where %.1f %% of the walls are straight and stand in free space of the others",
        100 * figure("straight_walls_added"));
  const auto sharpness = trustedValueOf(run.figures, "wall_sharpness");
  const std::string fault = sharpness && usual ? sharpnessFault(*sharpness, *usual) : "";
  return fault.empty() ? "" : "has walls that " + fault;
}

/** Why a map may not be rolled out; empty where it may, or where it cannot be known yet. */
std::string faultOf(const HistoryRun& run, bool isJudgeable, std::optional<double> usual,
                    const WatchOptions& options) {
  if (!run.isPlaced) return "fits no other map of the site";
  if (!trustedValueOf(run.figures, kMapError)) return isJudgeable ? "cannot be judged" : "";
  return mapFault(run, usual, options);
}

/** May the latest map be rolled out, with this fault; if not, which one stays? */
void advise(RobotWatch& watch, const std::string& fault, const SiteHistory& history) {
  const auto timeOf = [&](std::size_t run) { return history.runs[run].time; };
  const auto isOfOne = [&](const auto& textOf) {
    return watch.lastGood && watch.lastGood != watch.latest &&
           textOf(timeOf(*watch.lastGood)) == textOf(timeOf(watch.latest));
  };
  const auto stemOf = [&](std::size_t run) { return mapStem(history.runs[run].file); };
  const bool isOneDay = isOfOne(dayText), isOneTime = isOfOne(timeText);
  const bool isOneName = isOneTime && stemOf(*watch.lastGood) == stemOf(watch.latest);
  const auto whenOf = [&](std::size_t run) {
    const std::string when = isOneDay ? timeText(timeOf(run)) : dayText(timeOf(run));
    const std::string name = isOneName ? history.runs[run].file : stemOf(run);
    return isOneTime ? when + " (" + name + ")" : when;
  };
  const std::string map = "the map of " + whenOf(watch.latest);
  if (!fault.empty()) {
    watch.rollout = Rollout::no;
    watch.advice = "no, " + map + " " + fault +
                   (watch.lastGood ? ": keep that of " + whenOf(*watch.lastGood)
                                   : ", and no good one is known");
  } else if (watch.lastGood == watch.latest) {
    watch.rollout = Rollout::yes;
    watch.advice = "yes, " + map + " may be rolled out";
  } else {
    const std::string& reason = history.runs[watch.latest].reason;
    watch.advice =
        "not known yet: too few runs to judge " + map + (reason.empty() ? "" : ": " + reason);
  }
}

RobotWatch watchRobot(const std::string& robot, const SiteHistory& history,
                      std::optional<double> usual, const WatchOptions& options) {
  RobotWatch watch;
  watch.robot = robot;
  Samples errors;
  std::size_t others = 0;
  std::string fault;  // of the latest
  for (std::size_t i = 0; i < history.runs.size(); ++i) {
    const HistoryRun& run = history.runs[i];
    const bool isJudgeable = !run.isPlaced || others >= 2;
    others += run.isPlaced ? 1 : 0;
    if (run.robot != robot) continue;
    watch.latest = i;
    fault = faultOf(run, isJudgeable, usual, options);
    const auto error = run.isPlaced ? trustedValueOf(run.figures, kMapError) : std::nullopt;
    watch.unjudged = error || !isJudgeable ? 0 : watch.unjudged + 1;
    if (!error) continue;
    watch.runs.push_back(i);
    errors.push_back({run.time / kDay, *error});
    if (fault.empty()) watch.lastGood = i;
  }
  watch.errors = watchErrors(errors, options);
  advise(watch, fault, history);
  return watch;
}

std::string sentenceOf(const RobotWatch& watch, const SiteHistory& history,
                       const WatchOptions& options) {
  const ErrorWatch& errors = watch.errors;
  const auto dayOf = [&](std::size_t run) { return dayText(history.runs[run].time); };
  if (errors.isOverLimit)
    return std::string(watch.runs.size() > 1 ? "its latest maps are" : "its map is") +
           " above the limit of " + formatted("%.2f m", options.limit) +
           (watch.lastGood ? "; the last good one is of " + dayOf(*watch.lastGood)
                           : "; no good one is known");
  if (errors.isDeclining) {
    const std::string rate = formatted("%.3f m", 30 * errors.slope->perDay) + " in 30 days";
    return "its map gets worse, by " + rate +
           (errors.daysToLimit
                ? formatted("; the limit is reached in %.0f days", *errors.daysToLimit)
                : "");
  }
  if (errors.isChanged)
    return "its map has been worse since " + dayOf(watch.runs[errors.change->first]) + ", by " +
           formatted("%.2f m", errors.change->after - errors.change->before);
  if (watch.isLost())
    return "its last " + std::to_string(watch.unjudged) + " maps tell nothing of the site";
  if (watch.runs.empty()) return "no run of it can be judged yet";
  if (errors.isTooShort) return "too few nights to see a trend";
  return "its map is as good as ever";
}

/** What the runs say of one thing about one room. */
struct RoomSeries {
  std::vector<std::size_t> runs;
  std::vector<double> values;

  void add(std::size_t run, double value) { runs.push_back(run), values.push_back(value); }
};

/** By room and by what is counted. */
using AllSeries = std::map<std::pair<std::string, std::string>, RoomSeries>;

AllSeries seriesOf(const SiteHistory& history) {
  AllSeries series;
  std::set<std::string> corridors;
  for (const SiteRoom& room : history.ledger.rooms)
    if (room.isCorridor) corridors.insert(room.id);
  for (std::size_t i = 0; i < history.runs.size(); ++i) {
    const HistoryRun& run = history.runs[i];
    if (!run.isPlaced || !trustedValueOf(run.figures, kMapError) || isTorn(run)) continue;
    for (const RoomSeen& room : run.rooms) {
      const bool isSeen = room.sighting == RoomSighting::seen;
      if (room.sighting != RoomSighting::unvisited) series[{room.room, "seen"}].add(i, isSeen);
      // Pieces of a room, or several in one, say nothing of its doors.
      if (!isSeen || room.pieces != 1 || room.isMerged) continue;
      series[{room.room, "doors"}].add(i, room.doors);
      // Where a corridor is cut from the next is no wall that could have moved.
      if (room.area && corridors.count(room.room) == 0)
        series[{room.room, "area"}].add(i, *room.area);
    }
  }
  return series;
}

double toleranceOf(const std::string& what, const RoomSeries& series) {
  // Smaller changes of an area are drawing; doors are counted, and a room is seen or not.
  return what == "area" ? 0.15 * series.values.front() : 0.5;
}

}  // namespace

std::optional<LastingChange> lastingChange(const std::vector<double>& values, double tolerance,
                                           std::size_t least) {
  if (values.size() < 2 * least || least == 0) return {};
  std::size_t fewest = levelOf(values, 0, values.size(), tolerance).off;
  if (fewest < least) return {};
  fewest -= least - 1;
  std::optional<LastingChange> found;
  for (std::size_t first = least; first + least <= values.size(); ++first) {
    const Level before = levelOf(values, 0, first, tolerance);
    const Level after = levelOf(values, first, values.size(), tolerance);
    const bool isChange = std::abs(after.value - before.value) > tolerance;
    if (!isChange || !isSteady(before) || !isSteady(after)) continue;
    if (before.off + after.off >= fewest) continue;
    fewest = before.off + after.off;
    found = LastingChange{first, before.value, after.value};
  }
  return found;
}

std::vector<LastingChange> lastingChanges(const std::vector<double>& values, double tolerance,
                                          std::size_t least) {
  std::vector<LastingChange> changes;
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= values.size(); ++end) {
    if (end - begin > 60) begin = end - 60;
    const auto at = [&](std::size_t i) { return values.begin() + std::ptrdiff_t(i); };
    auto found = lastingChange({at(begin), at(end)}, tolerance, least);
    if (!found) continue;
    found->first += begin;
    begin = found->first;
    changes.push_back(*found);
  }
  return changes;
}

SiteWatch watchSite(const SiteHistory& history, const WatchOptions& options) {
  SiteWatch watch;
  std::set<std::string> robots;
  for (const HistoryRun& run : history.runs) robots.insert(run.robot);
  const auto usual = usualSharpness(history);
  for (const std::string& robot : robots) {
    watch.robots.push_back(watchRobot(robot, history, usual, options));
    watch.robots.back().sentence = sentenceOf(watch.robots.back(), history, options);
  }
  for (const auto& [key, series] : seriesOf(history))
    for (const LastingChange& change :
         lastingChanges(series.values, toleranceOf(key.second, series), 5))
      watch.changes.push_back(
          {key.first, key.second, series.runs[change.first], change.before, change.after});
  sortBy(watch.changes, &RoomChange::run);
  return watch;
}

SiteHistory historyUpTo(SiteHistory history, const std::string& sha256) {
  const auto last = std::find_if(history.runs.begin(), history.runs.end(),
                                 [&](const HistoryRun& run) { return run.sha256 == sha256; });
  if (last != history.runs.end()) history.runs.erase(last + 1, history.runs.end());
  return history;
}

std::string changeText(const RoomChange& change, const SiteHistory& history) {
  std::string name = change.room;
  for (const SiteRoom& room : history.ledger.rooms)
    if (room.id == change.room && room.name != room.id) name += " " + room.name;
  const std::string since = " since " + dayText(history.runs[change.run].time);
  if (change.what == "seen")
    return name + (change.after > change.before ? ": is there" : ": is gone") + since;
  if (change.what == "area")
    return name + formatted(": %.1f m²", change.after) +
           formatted(" instead of %.1f m²", change.before) + since;
  return name + formatted(change.after == 1 ? ": %.0f door" : ": %.0f doors", change.after) +
         formatted(" instead of %.0f", change.before) + since;
}

}  // namespace roomgraph
