#include "roomgraph/archive/plan_fleet.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "roomgraph/archive/record_files.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/csv_text.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/base/version.h"
#include "roomgraph/map_files/map_sha256.h"

namespace roomgraph {
namespace {

using Cells = std::vector<std::string>;

struct Columns {
  std::optional<std::size_t> site, file, robot, time;
};

/** @throws DataError for a line that says too little, or something else. */
RunList::value_type runOf(const Cells& cells, const Columns& columns, const std::string& folder,
                          const std::string& where) {
  const auto cell = [&](std::optional<std::size_t> column) {
    return column && *column < cells.size() ? cells[*column] : std::string();
  };
  if (cell(columns.site).empty() || cell(columns.file).empty())
    throw DataError(where + " has no site or no file: fill it in, or take the line out");
  HistoryRun run;
  run.robot = cell(columns.robot).empty() ? "robot" : cell(columns.robot);
  run.file = std::filesystem::absolute(std::filesystem::path(folder) / cell(columns.file))
                 .lexically_normal()
                 .string();
  const std::string time = cell(columns.time);
  const auto seconds = time.empty() ? std::optional<double>(NAN) : parseTime(time);
  if (!seconds) throw DataError(where + ": '" + time + "' is not a time: give 2026-11-22T03:00");
  if (isToCome(*seconds))
    throw DataError(where + ": '" + time + "' is still to come: give the time of the run");
  run.time = *seconds;
  return {cell(columns.site), run};
}

/** The new runs of a site, by content. */
using NewRuns = std::map<std::string, HistoryRun>;

std::map<std::string, NewRuns> newRunsOf(const RunList& listed, const Archive& archive,
                                         const PlanFleetOptions& options) {
  std::map<std::string, NewRuns> sites;
  for (auto [site, run] : listed) {
    try {
      run.sha256 = mapSha256(run.file);
      if (archive.knows(site, run.sha256)) continue;
      if (std::isnan(run.time)) run.time = runTime(run.file);
      sites[site].insert({run.sha256, run});
    } catch (const DataError& error) {
      options.onUnread(printable(site) + ": " + error.what());
    }
  }
  return sites;
}

}  // namespace

RunList readRunList(const std::string& text, const std::string& name, const std::string& folder,
                    const std::function<void(const std::string&)>& onBadLine) {
  CsvReader reader(text, name);
  const Cells names = reader.nextLine();
  const Columns columns{columnOf(names, "site"), columnOf(names, "file"), columnOf(names, "robot"),
                        columnOf(names, "time")};
  if (!columns.site || !columns.file) {
    const std::string missing = columns.file   ? "column 'site'"
                                : columns.site ? "column 'file'"
                                               : "columns 'site' and 'file'";
    throw DataError(name + ": has no " + missing +
                    ": name the columns in its first line, separated by commas");
  }
  RunList runs;
  while (!reader.isAtEnd()) {
    try {
      const Cells cells = reader.nextLine();
      if (cells.size() == 1 && cells[0].empty()) continue;
      runs.push_back(
          runOf(cells, columns, folder, name + ": line " + std::to_string(reader.line())));
    } catch (const DataError& error) {
      onBadLine(error.what());
    }
  }
  if (runs.empty())
    throw DataError(name + ": lists no run: look at what has written it, or add one");
  return runs;
}

std::vector<FleetTask> planFleet(const RunList& listed, const Archive& archive,
                                 const PlanFleetOptions& options) {
  std::vector<FleetTask> tasks;
  for (const auto& [site, news] : newRunsOf(listed, archive, options)) {
    FleetTask task;
    task.site = site, task.newRuns = news.size();
    for (const auto& [sha256, run] : news) task.runs.push_back(run);
    for (const HistoryRun& run : recordRuns(archive.runs(site), options.most, options.onMissing))
      task.runs.push_back(run);
    task.key = keyOf(task, options.compare);
    tasks.push_back(std::move(task));
  }
  return tasks;
}

std::string keyOf(const FleetTask& task, const CompareMapsOptions& options) {
  std::set<std::string> runs;
  for (const HistoryRun& run : task.runs) runs.insert(run.sha256 + " " + run.file + "\n");
  std::string text = std::string(version()) + "\n" + task.site + "\n";
  for (const std::string& run : runs) text += run;
  for (const UsedOption& used : usedOptions(options))
    text += used.section + "." + used.name + "=" + used.value + "\n";
  return sha256Of(viewOf(text));
}

}  // namespace roomgraph
