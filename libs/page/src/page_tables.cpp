#include "page_tables.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "page_data.h"
#include "page_summary.h"
#include "page_values.h"
#include "room_rows.h"
#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/base/version.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/measures/measure_kinds.h"
#include "roomgraph/page/site_pictures.h"

namespace roomgraph {
namespace {

using kainjow::mustache::data;
using page_values::flag;
using page_values::rowsOf;
using page_values::text;

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

data measureCell(const Measure* measure) {
  data cell;
  cell.set("value", measure ? valueText(measure->value, measure->unit) : "–");
  const bool isShare = measure && measure->unit == "1";
  const auto scaled = [&](std::optional<double> value) -> std::optional<double> {
    if (!value) return std::nullopt;
    return isShare ? 100 * *value : *value;
  };
  if (measure)
    cell.set("range", rangeText(scaled(measure->low), scaled(measure->high), isShare ? 0 : 2));
  cell.set("weak", flag(!measure || !measure->isMeaningful));
  return cell;
}

class Tables {
 public:
  explicit Tables(const Comparison& comparison) : comparison_(comparison) {
    for (const ComparedRun& run : comparison.runs) places_.emplace(run.name, places_.size());
  }

  data runs() const {
    return rowsOf(comparison_.runs,
                  [&](const ComparedRun& run, std::size_t i) { return runRow(run, i); });
  }

  data measureNames() const {
    return rowsOf(allMeasures(), [](const Measure& measure, std::size_t) {
      data name;
      name.set("name", text(labelOf(measure)));
      name.set("unit", unitText(measure.unit));
      return name;
    });
  }

  data breaks() const {
    return rowsOf(comparison_.breaks, [&](const MapBreak& tear, std::size_t i) {
      data row = runCell(tear.run);
      row.set("index", std::to_string(i));
      row.set("x", fixedText(tear.place.x, 1));
      row.set("y", fixedText(tear.place.y, 1));
      row.set("turn", fixedText(tear.rotation * 180 / M_PI, 1));
      row.set("shift", fixedText(tear.shift, 2));
      row.set("class", nameOf(tear.kind()));
      row.set("frame", tear.keyFrame ? std::to_string(*tear.keyFrame) : "–");
      row.set("time", tear.time ? timeText(*tear.time) : "–");
      return row;
    });
  }

  data pairs() const {
    return rowsOf(comparison_.pairs, [](const ComparedPair& pair, std::size_t) {
      data row;
      row.set("a", text(pair.a));
      row.set("b", text(pair.b));
      row.set("same", flag(pair.isSameSite));
      row.set("confidence", fixedText(pair.confidence, 2));
      row.set("doubtful", flag(pair.isSameSite && pair.confidence < kSureConfidence));
      row.set("overlap", pair.transform ? percentText(pair.overlap) : "–");
      row.set("distance", valueText(valueOf(pair.measures, "wall_distance"), "m"));
      row.set("runnerUp", pair.runnerUp ? fixedText(pair.runnerUpConfidence, 2) : "–");
      return row;
    });
  }

  data leftOut() const {
    return rowsOf(comparison_.leftOut, [](const LeftOutRun& run, std::size_t) {
      data row;
      row.set("name", text(run.name));
      row.set("file", text(fileName(run.file)));
      row.set("reason", text(run.reason));
      return row;
    });
  }

 private:
  data runCell(const std::string& name) const {
    const auto found = places_.find(name);
    const std::size_t place = found == places_.end() ? 0 : found->second;
    data cell;
    cell.set("run", text(name));
    cell.set("colour", colourText(place));
    cell.set("shape", runShape(place));
    cell.set("pattern", std::to_string(int(runPattern(place))));
    return cell;
  }

  data runRow(const ComparedRun& run, std::size_t i) const {
    data row = runCell(run.name);
    row.set("index", std::to_string(i));
    row.set("rank", run.rank ? std::to_string(run.rank) : "–");
    row.set("isReference", flag(comparison_.reference == run.name));
    row.set("file", text(fileName(run.file)));
    row.set("hash", text(run.sha256));
    row.set("dates", datesOf(run.path));
    row.set("reason", text(run.reason));
    row.set("weak", flag(run.score && !run.score->isMeaningful));
    row.set("score", run.score ? fixedText(run.score->score, 1) : "–");
    row.set("error", run.score ? fixedText(run.score->mapError, 2) : "–");
    if (run.score) {
      row.set("scoreRange", rangeText(run.score->low, run.score->high, 1));
      row.set("errorRange", rangeText(run.score->errorLow, run.score->errorHigh, 2));
    }
    row.set("breaks", std::to_string(breaksOf(run.name)));
    const Measure* coverage = find(run.measures, "coverage");
    row.set("coverage", coverage ? valueText(coverage->value, coverage->unit) : "–");
    row.set("measures", rowsOf(allMeasures(), [&](const Measure& measure, std::size_t) {
              return measureCell(find(run.measures, measure.name));
            }));
    row.set("isShown", flag(isShownAtFirst(i)));
    return row;
  }

  /** The best run and those that are torn; all where none is. */
  bool isShownAtFirst(std::size_t i) const {
    if (i >= 12) return false;  // more hide each other
    return i == 0 || comparison_.breaks.empty() || breaksOf(comparison_.runs[i].name) > 0;
  }

  std::size_t breaksOf(const std::string& run) const {
    return std::size_t(std::count_if(comparison_.breaks.begin(), comparison_.breaks.end(),
                                     [&](const MapBreak& tear) { return tear.run == run; }));
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

data optionRows(const std::vector<UsedOption>& options) {
  return rowsOf(options, [](const UsedOption& option, std::size_t) {
    data row;
    row.set("key", text(option.section + (option.section.empty() ? "" : ".") + option.name));
    row.set("value", text(option.value));
    row.set("unit", text(option.unit));
    row.set("sentence", text(option.sentence));
    return row;
  });
}

data heatRows() {
  return rowsOf(heatColours(), [](const Colour& c, std::size_t i) {
    data row;
    row.set("colour", "rgb(" + std::to_string(c.red) + "," + std::to_string(c.green) + "," +
                          std::to_string(c.blue) + ")");
    row.set("upTo", std::to_string(10 * (i + 1)));
    return row;
  });
}

}  // namespace

data pageTables(const Comparison& comparison) {
  const Tables tables(comparison);
  data page;
  page.set("version", version());
  // The first sentence is the headline, what qualifies it stands below.
  const std::size_t end = std::min(comparison.verdict.find(". "), comparison.verdict.size() - 1);
  page.set("verdict", text(comparison.verdict.substr(0, end + 1)));
  page.set("caveats",
           text(comparison.verdict.substr(std::min(end + 2, comparison.verdict.size()))));
  page.set("counts", pageCounts(comparison));
  page.set("summary", rowsOf(pageSummary(comparison), [](const std::string& sentence, std::size_t) {
             return text(sentence);
           }));
  page.set("runs", tables.runs());
  page.set("runsAreMany", flag(comparison.runs.size() > 30));
  page.set("measureNames", tables.measureNames());
  page.set("command", text(commandLine(comparison)));
  page.set("hasPairs", flag(comparison.runs.size() > 1));
  page.set("hasRooms", flag(!comparison.rooms.empty()));
  page.set("rooms", roomRows(comparison.rooms));
  page.set("hasBreaks", flag(!comparison.breaks.empty()));
  page.set("breaks", tables.breaks());
  page.set("pairs", tables.pairs());
  page.set("pairsAreFew", flag(comparison.pairs.size() <= 60));
  page.set("hasLeftOut", flag(!comparison.leftOut.empty()));
  page.set("leftOut", tables.leftOut());
  page.set("options", optionRows(comparison.options));
  page.set("heat", heatRows());
  return page;
}

}  // namespace roomgraph
