#include "roomgraph/evaluation/write_stability.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "roomgraph/base/Json.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/version.h"

namespace roomgraph {
namespace {

std::optional<double> valueOf(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional<double>(json.get<double>());
}

Json json(const GraphDistance& d) {
  return {orNull(d.nearest), orNull(d.agreement.median), orNull(d.agreement.percentile90),
          orNull(d.agreement.unmatchedBase), orNull(d.agreement.unmatchedOther)};
}

GraphDistance distanceOf(const Json& json) {
  return {valueOf(json.at(0)),
          {valueOf(json.at(1)), valueOf(json.at(2)), valueOf(json.at(3)), valueOf(json.at(4))}};
}

Json json(const StabilityRun& run, const RunMeasures& measures) {
  return {{"distance", run.noise.maxDistance},
          {"percent", run.noise.percent},
          {"repeat", run.repeat},
          {"room", json(measures.room)},
          {"no_room", json(measures.noRoom)},
          {"rooms_found", orNull(measures.roomsFound)},
          {"rooms", measures.rooms}};
}

RunMeasures measuresOf(const Json& json) {
  return {distanceOf(json.at("room")), distanceOf(json.at("no_room")),
          valueOf(json.at("rooms_found")), json.at("rooms").get<int>()};
}

using RunName = std::tuple<int, double, int>;

std::map<RunName, RunMeasures> allMeasures(const Json& runs) {
  std::map<RunName, RunMeasures> all;
  for (const Json& run : runs)
    all[{run.at("distance").get<int>(), run.at("percent").get<double>(),
         run.at("repeat").get<int>()}] = measuresOf(run);
  return all;
}

using Value = std::optional<double>;

struct Column {
  std::string name;
  Value value;
};
using Columns = std::vector<Column>;

Value times(Value value, double factor) { return value ? Value(factor * *value) : std::nullopt; }

/** The distances of the graphs with rooms beside those without; `ratio` of a row alone. */
void addMeasures(Columns& columns, const GraphDistance& room, const GraphDistance& noRoom,
                 const Columns& ratio, Value roomsFound, double resolution) {
  columns.push_back({"room", times(room.nearest, 1 / resolution)});
  columns.push_back({"no_room", times(noRoom.nearest, 1 / resolution)});
  columns.insert(columns.end(), ratio.begin(), ratio.end());
  const auto both = [&](const std::string& name, double factor, Value VertexAgreement::*member) {
    columns.push_back({"room_" + name, times(room.agreement.*member, factor)});
    columns.push_back({"no_room_" + name, times(noRoom.agreement.*member, factor)});
  };
  both("median", 1 / resolution, &VertexAgreement::median);
  both("p90", 1 / resolution, &VertexAgreement::percentile90);
  both("unmatched_base_percent", 100, &VertexAgreement::unmatchedBase);
  both("unmatched_other_percent", 100, &VertexAgreement::unmatchedOther);
  columns.push_back({"rooms_found_percent", times(roomsFound, 100)});
}

/** Behind those that are there. */
Columns measuresOf(const StabilityRow& row, double resolution, Columns columns = {}) {
  addMeasures(columns, row.room, row.noRoom, {{"ratio_percent", times(row.ratio, 100)}},
              row.roomsFound, resolution);
  columns.push_back({"rooms_change", row.roomsChange});
  return columns;
}

Columns columnsOf(const StabilityRow& row, double resolution) {
  return measuresOf(row, resolution, {{"distance_px", row.distance}, {"percent", row.percent}});
}

Columns columnsOf(const StabilityRun& run, const RunMeasures& measures, double resolution) {
  Columns columns{{"distance_px", run.noise.maxDistance},
                  {"percent", run.noise.percent},
                  {"repeat", run.repeat}};
  addMeasures(columns, measures.room, measures.noRoom, {}, measures.roomsFound, resolution);
  columns.push_back({"rooms", measures.rooms});
  return columns;
}

Json json(const Columns& columns) {
  Json object = Json::object();
  for (const Column& column : columns) {
    if (!column.value)
      object[column.name] = nullptr;
    else if (*column.value == std::floor(*column.value))
      object[column.name] = std::int64_t(*column.value);
    else
      object[column.name] = rounded(*column.value);
  }
  return object;
}

Json inputJson(const Stability& result) {
  Json input{{"file", fileName(result.source.file)},
             {"sha256", result.source.sha256},
             {"kind", result.source.kind},
             {"resolution", result.frame.resolution},
             {"size", {result.frame.width, result.frame.height}}};
  if (!result.source.insertion.empty()) input["insertion"] = result.source.insertion;
  return input;
}

/** Sections of keys, as in the file of a graph. */
Json optionsJson(const ExtractOptions& options) {
  ExtractOptions copy = options;
  const FieldTable table = describe(copy);
  Json json = Json::object();
  for (const Field& field : table.fields())
    std::visit([&](const auto* value) { json[field.section][field.name] = *value; }, field.value);
  return json;
}

Json experimentJson(const StabilityOptions& options) {
  return {{"distances_px", options.distances},
          {"percents", options.percents},
          {"repeats", options.repeats},
          {"seed", options.seed},
          {"base_distance_px", options.baseDistance},
          {"base_percent", options.basePercent},
          {"match_within_m", options.matchWithin}};
}

Json baseJson(const Stability& result) {
  return {{"vertices_room", result.baseVerticesRoom},
          {"vertices_no_room", result.baseVerticesNoRoom},
          {"rooms", result.baseRooms}};
}

std::string valueText(const char* format, Value value, const char* missing) {
  return value ? formatted(format, *value) : missing;
}

std::string number(Value value, int width) {
  const std::string text = valueText("%.2f", value, "-");
  return std::string(std::size_t(std::max(0, width - int(text.size()))), ' ') + text;
}

std::string tableLine(const std::string& first, const StabilityRow& row, double resolution) {
  return first + number(times(row.room.nearest, 1 / resolution), 10) +
         number(times(row.noRoom.nearest, 1 / resolution), 10) + number(times(row.ratio, 100), 10) +
         "\n";
}

std::string soundLine(const char* name, Value room, Value noRoom) {
  Value ratio;
  if (room && noRoom && *noRoom > 0) ratio = 100 * *room / *noRoom;
  return formatted("%-38s", name) + number(room, 10) + number(noRoom, 10) + number(ratio, 10) +
         "\n";
}

std::string soundText(const Stability& result) {
  const VertexAgreement &room = result.mean.room.agreement, &noRoom = result.mean.noRoom.agreement;
  const double toPx = 1 / result.frame.resolution;
  std::string text =
      "One to one, at most " + valueText("%g", result.options.matchWithin, "") + " m apart:\n";
  text += soundLine("median distance [px]", times(room.median, toPx), times(noRoom.median, toPx));
  text += soundLine("90th percentile [px]", times(room.percentile90, toPx),
                    times(noRoom.percentile90, toPx));
  text += soundLine("unmatched of the base map [%]", times(room.unmatchedBase, 100),
                    times(noRoom.unmatchedBase, 100));
  text += soundLine("unmatched of the noisy map [%]", times(room.unmatchedOther, 100),
                    times(noRoom.unmatchedOther, 100));
  text += "Rooms found again " + valueText("%.1f %%", times(result.mean.roomsFound, 100), "-") +
          ", change in their number " + valueText("%.2f", result.mean.roomsChange, "") + " of " +
          std::to_string(result.baseRooms) + "\n";
  return text;
}

}  // namespace

std::string stabilityKey(const GreyMap::Source& source, const ExtractOptions& extract,
                         const StabilityOptions& options) {
  return lineOf(Json{{"version", version()},
                     {"sha256", source.sha256},
                     {"options", optionsJson(extract)},
                     {"seed", options.seed},
                     {"base", {options.baseDistance, options.basePercent}},
                     {"match_within", options.matchWithin}});
}

std::string progressText(const std::string& key, const std::vector<StabilityRun>& runs,
                         const RunsDone& done) {
  std::string text =
      "{\n\"format\": \"roomgraph/stability_progress\",\n\"key\": " + key + ",\n\"runs\": [";
  const char* separator = "\n";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!done[i]) continue;
    text += separator + lineOf(json(runs[i], *done[i]));
    separator = ",\n";
  }
  return text + "\n]\n}\n";
}

RunsDone readProgress(const std::string& text, const std::string& key,
                      const std::vector<StabilityRun>& runs) {
  RunsDone done(runs.size());
  try {
    const Json file = Json::parse(text);
    if (lineOf(file.at("key")) != key) return done;
    const std::map<RunName, RunMeasures> known = allMeasures(file.at("runs"));
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const auto found =
          known.find({runs[i].noise.maxDistance, runs[i].noise.percent, runs[i].repeat});
      if (found != known.end()) done[i] = found->second;
    }
  } catch (const Json::exception&) {
    return RunsDone(runs.size());  // damaged: everything is computed anew
  }
  return done;
}

std::string stabilityCsv(const Stability& result) {
  std::string header, lines;
  for (const StabilityRow& row : result.rows) {
    header.clear();
    std::string line;
    for (const Column& column : columnsOf(row, result.frame.resolution)) {
      const bool isWhole = column.value && *column.value == std::floor(*column.value);
      header += "," + column.name;
      line += "," + valueText(isWhole ? "%.0f" : "%.4f", column.value, "");
    }
    lines += line.substr(1) + "\n";
  }
  return header.substr(1) + "\n" + lines;
}

std::string stabilityJson(const Stability& result) {
  const double resolution = result.frame.resolution;
  JsonDocument document("roomgraph/stability");
  document.add("input", inputJson(result));
  document.add("options", optionsJson(result.extract));
  document.add("experiment", experimentJson(result.options));
  document.add("base", baseJson(result));
  document.add("mean", json(measuresOf(result.mean, resolution)));
  document.addList("rows", result.rows,
                   [&](const StabilityRow& row) { return json(columnsOf(row, resolution)); });
  document.addEntries("runs", result.runs.size(), [&](std::size_t i) {
    return lineOf(json(columnsOf(result.runs[i], result.measures[i], resolution)));
  });
  return std::move(document).text();
}

std::string stabilityText(const Stability& result) {
  std::string text = "distance [px]  percent  room [px]   no room ratio [%]\n";
  for (const StabilityRow& row : result.rows)
    text +=
        tableLine(formatted("%13d%9g ", row.distance, row.percent), row, result.frame.resolution);
  const std::string rows = std::to_string(result.rows.size()) + " rows";
  return text +
         tableLine(formatted("mean of %-15s", rows.c_str()), result.mean, result.frame.resolution) +
         soundText(result);
}

}  // namespace roomgraph
