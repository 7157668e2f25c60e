#include "page_tables.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "page_data.h"
#include "page_summary.h"
#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/base/utf8_text.h"
#include "roomgraph/base/version.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/measures/measure_kinds.h"
#include "roomgraph/page/site_pictures.h"

namespace roomgraph {
namespace {

/** A list with what `toRow` makes of each thing and its place, in their order. */
template <class Things, class ToRow>
Json rowsOf(const Things& things, const ToRow& toRow) {
  Json rows = Json::array();
  for (const auto& thing : things) rows.push_back(toRow(thing, rows.size()));
  return rows;
}

void setSightings(Json& row, const SiteRoom& room) {
  std::size_t seen = 0, gone = 0;
  Json dots = Json::array();
  for (const RoomInRun& one : room.runs) {
    const bool isSeen = one.sighting == RoomSighting::seen;
    const bool isGone = one.sighting == RoomSighting::gone;
    seen += isSeen, gone += isGone;
    dots.push_back({{"kind", nameOf(one.sighting)},
                    {"title", one.run + (isSeen   ? ": seen"
                                         : isGone ? ": looked there, no such room"
                                                  : ": has not looked there")}});
  }
  row["seen"] = std::to_string(seen);
  row["of"] = std::to_string(room.runs.size());
  row["gone"] = gone ? std::to_string(gone) : std::string();
  row["hasGone"] = gone > 0;
  row["isStrip"] = room.runs.size() <= 16;
  row["dots"] = dots;
}

void setChanges(Json& row, const SiteRoom& room) {
  const RoomInRun* far = nullptr;
  int gained = 0, lost = 0, split = 0, merged = 0;
  for (const RoomInRun& one : room.runs) {
    if (one.shift && (!far || *one.shift > *far->shift)) far = &one;
    gained += one.doorsGained > 0, lost += one.doorsLost > 0;
    split += one.pieces > 1, merged += one.isMerged;
  }
  row["shift"] = far ? fixedText(far->shift, 2) : "–";
  row["shiftRun"] = far ? far->run : "";
  std::string changes;
  const auto add = [&](int count, const char* what) {
    if (count == 0) return;
    changes += (changes.empty() ? "" : ", ") + std::string(what) + " in " + std::to_string(count);
  };
  add(split, "split"), add(merged, "merged"), add(gained, "new door"), add(lost, "lost door");
  row["changes"] = changes;
  const bool isSeenByAll =
      allOf(room.runs, [](const RoomInRun& one) { return one.sighting == RoomSighting::seen; });
  row["isSame"] = isSeenByAll && changes.empty();
}

Json roomRow(const SiteRoom& room, std::size_t i) {
  Json row{{"index", std::to_string(i)},
           {"id", room.id},
           {"name", room.name},
           {"hasName", room.name != room.id && !room.name.empty()},
           {"kind", room.isCorridor ? "corridor" : "room"},
           {"area", fixedText(room.area, 1)}};
  setSightings(row, room);
  setChanges(row, room);
  return row;
}

/** "0.12" for metres, "93 %" for shares. */
std::string valueText(std::optional<double> value, const std::string& unit) {
  if (!value) return "–";
  return unit == "1" ? percentText(*value) : fixedText(value, 2);
}

std::string rangeText(std::optional<double> low, std::optional<double> high, int digits) {
  return low && high ? fixedText(low, digits) + " – " + fixedText(high, digits) : "";
}

/** "[m]" for metres; nothing for shares, which say it themselves, and for what is counted. */
std::string unitText(const std::string& unit) {
  return unit == "1" || unit == "pieces" ? "" : "[" + unit + "]";
}

/** From when to when a run was; the day once. */
std::string datesOf(const std::vector<PathPose>& path) {
  std::optional<double> first, last;
  for (const PathPose& at : path) {
    if (!at.time) continue;
    first = std::min(first.value_or(*at.time), *at.time);
    last = std::max(last.value_or(*at.time), *at.time);
  }
  if (!first) return "–";
  const std::string start = timeText(*first), end = timeText(*last);
  return start + " – " + (dayText(*first) == dayText(*last) ? end.substr(end.find('T') + 1) : end);
}

/** "wall_distance_p90" for people. A file of a later version may have measures unknown here. */
std::string labelOf(const Measure& measure) {
  const MeasureKind* kind = findMeasureKind(measure.name);
  return kind ? kind->label : measure.name;
}

Json measureCell(const Measure* measure) {
  Json cell{{"value", measure ? valueText(measure->value, measure->unit) : "–"},
            {"weak", !measure || !measure->isMeaningful}};
  const bool isShare = measure && measure->unit == "1";
  const auto scaled = [&](std::optional<double> value) -> std::optional<double> {
    if (!value) return std::nullopt;
    return isShare ? 100 * *value : *value;
  };
  if (measure)
    cell["range"] = rangeText(scaled(measure->low), scaled(measure->high), isShare ? 0 : 2);
  return cell;
}

class Tables {
 public:
  explicit Tables(const Comparison& comparison) : comparison_(comparison) {
    for (const ComparedRun& run : comparison.runs) places_.emplace(run.name, places_.size());
  }

  Json runs() const {
    return rowsOf(comparison_.runs,
                  [&](const ComparedRun& run, std::size_t i) { return runRow(run, i); });
  }

  Json measureNames() const {
    return rowsOf(allMeasures(), [](const Measure& measure, std::size_t) {
      return Json{{"name", labelOf(measure)}, {"unit", unitText(measure.unit)}};
    });
  }

  Json breaks() const {
    return rowsOf(comparison_.breaks, [&](const MapBreak& tear, std::size_t i) {
      Json row = runCell(tear.run);
      row["index"] = std::to_string(i);
      row["x"] = fixedText(tear.place.x, 1);
      row["y"] = fixedText(tear.place.y, 1);
      row["turn"] = fixedText(tear.rotation * 180 / M_PI, 1);
      row["shift"] = fixedText(tear.shift, 2);
      row["class"] = nameOf(tear.kind());
      row["frame"] = tear.keyFrame ? std::to_string(*tear.keyFrame) : "–";
      row["time"] = tear.time ? timeText(*tear.time) : "–";
      return row;
    });
  }

  Json pairs() const {
    return rowsOf(comparison_.pairs, [](const ComparedPair& pair, std::size_t) {
      return Json{{"a", pair.a},
                  {"b", pair.b},
                  {"same", pair.isSameSite},
                  {"confidence", fixedText(pair.confidence, 2)},
                  {"doubtful", pair.isSameSite && pair.confidence < kSureConfidence},
                  {"overlap", pair.transform ? percentText(pair.overlap) : "–"},
                  {"distance", valueText(valueOf(pair.measures, "wall_distance"), "m")},
                  {"runnerUp", pair.runnerUp ? fixedText(pair.runnerUpConfidence, 2) : "–"}};
    });
  }

  Json leftOut() const {
    return rowsOf(comparison_.leftOut, [](const LeftOutRun& run, std::size_t) {
      return Json{
          {"name", run.name}, {"file", utf8Text(fileName(run.file))}, {"reason", run.reason}};
    });
  }

 private:
  Json runCell(const std::string& name) const {
    const auto found = places_.find(name);
    const std::size_t place = found == places_.end() ? 0 : found->second;
    return {{"run", name},
            {"colour", colourText(place)},
            {"shape", runShape(place)},
            {"pattern", std::to_string(int(runPattern(place)))}};
  }

  Json runRow(const ComparedRun& run, std::size_t i) const {
    Json row = runCell(run.name);
    row["index"] = std::to_string(i);
    row["rank"] = run.rank ? std::to_string(run.rank) : "–";
    row["isReference"] = comparison_.reference == run.name;
    row["file"] = utf8Text(fileName(run.file));
    row["hash"] = run.sha256;
    row["dates"] = datesOf(run.path);
    row["reason"] = run.reason;
    row["weak"] = run.score && !run.score->isMeaningful;
    row["score"] = run.score ? fixedText(run.score->score, 1) : "–";
    row["error"] = run.score ? fixedText(run.score->mapError, 2) : "–";
    if (run.score) {
      row["scoreRange"] = rangeText(run.score->low, run.score->high, 1);
      row["errorRange"] = rangeText(run.score->errorLow, run.score->errorHigh, 2);
    }
    row["breaks"] = breaksText(run.name);
    const Measure* coverage = find(run.measures, "coverage");
    row["coverage"] = coverage ? valueText(coverage->value, coverage->unit) : "–";
    row["measures"] = rowsOf(allMeasures(), [&](const Measure& measure, std::size_t) {
      return measureCell(find(run.measures, measure.name));
    });
    row["isShown"] = isShownAtFirst(i);
    return row;
  }

  /** The best run and those that are torn; all where none is. */
  bool isShownAtFirst(std::size_t i) const {
    if (i >= 12) return false;  // more hide each other
    return i == 0 || comparison_.breaks.empty() || breaksOf(comparison_.runs[i].name) > 0;
  }

  std::size_t breaksOf(const std::string& run) const {
    return countIf(comparison_.breaks, [&](const MapBreak& tear) { return tear.run == run; });
  }

  /** The verdict counts no slight ones: "1 + 1 slight". */
  std::string breaksText(const std::string& run) const {
    const std::size_t others = comparison_.countBreaks(run), slight = breaksOf(run) - others;
    if (slight == 0) return std::to_string(others);
    return (others > 0 ? std::to_string(others) + " + " : "") + std::to_string(slight) + " slight";
  }

  /** Those of the first run that has any: all runs have the same. */
  const std::vector<Measure>& allMeasures() const {
    static const std::vector<Measure> none;
    for (const ComparedRun& run : comparison_.runs)
      if (!run.measures.empty()) return run.measures;
    return none;
  }

  const Comparison& comparison_;
  std::map<std::string, std::size_t> places_;
};

Json optionRows(const std::vector<UsedOption>& options) {
  return rowsOf(options, [](const UsedOption& option, std::size_t) {
    return Json{{"key", option.section + (option.section.empty() ? "" : ".") + option.name},
                {"value", option.value},
                {"unit", option.unit},
                {"sentence", option.sentence}};
  });
}

Json heatRows() {
  return rowsOf(heatColours(), [](const Colour& c, std::size_t i) {
    return Json{{"colour", formatted("rgb(%d,%d,%d)", c.red, c.green, c.blue)},
                {"upTo", std::to_string(10 * (i + 1))}};
  });
}

}  // namespace

Json roomRows(const std::vector<SiteRoom>& rooms) { return rowsOf(rooms, roomRow); }

Json pageTables(const Comparison& comparison) {
  const Tables tables(comparison);
  // The first sentence is the headline, what qualifies it stands below.
  const std::string verdict = pageVerdict(comparison);
  const std::size_t end = std::min(verdict.find(". "), verdict.size() - 1);
  return {{"version", version()},
          {"verdict", verdict.substr(0, end + 1)},
          {"caveats", verdict.substr(std::min(end + 2, verdict.size()))},
          {"counts", pageCounts(comparison)},
          {"summary", pageSummary(comparison)},
          {"runs", tables.runs()},
          {"runsAreMany", comparison.runs.size() > 30},
          {"measureNames", tables.measureNames()},
          {"command", commandLine(comparison)},
          {"hasPairs", comparison.runs.size() > 1},
          {"hasRooms", !comparison.rooms.empty()},
          {"rooms", roomRows(comparison.rooms)},
          {"hasBreaks", !comparison.breaks.empty()},
          {"breaks", tables.breaks()},
          {"pairs", tables.pairs()},
          {"pairsAreFew", comparison.pairs.size() <= 60},
          {"hasLeftOut", !comparison.leftOut.empty()},
          {"leftOut", tables.leftOut()},
          {"options", optionRows(comparison.options)},
          {"heat", heatRows()}};
}

}  // namespace roomgraph
