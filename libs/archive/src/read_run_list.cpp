#include "roomgraph/archive/read_run_list.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/csv_text.h"
#include "roomgraph/base/time_text.h"

namespace roomgraph {
namespace {

using Cells = std::vector<std::string>;

std::optional<std::size_t> columnOf(const Cells& names, const char* name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return {};
  return std::size_t(found - names.begin());
}

/** Where the columns are. */
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
  run.time = *seconds;
  return {cell(columns.site), run};
}

}  // namespace

RunList readRunList(const std::string& text, const std::string& name, const std::string& folder,
                    const std::function<void(const std::string&)>& onBadLine) {
  CsvReader reader(text);
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
    const Cells cells = reader.nextLine();
    if (cells.size() == 1 && cells[0].empty()) continue;
    try {
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

}  // namespace roomgraph
