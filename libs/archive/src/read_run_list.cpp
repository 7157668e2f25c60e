#include "roomgraph/archive/read_run_list.h"

#include <algorithm>
#include <filesystem>

#include "roomgraph/base/CsvReader.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/time_text.h"

namespace roomgraph {
namespace {

using Cells = std::vector<std::string>;

std::optional<std::size_t> columnOf(const Cells& names, const char* name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return {};
  return std::size_t(found - names.begin());
}

}  // namespace

std::vector<ListedRun> readRunList(const std::string& text, const std::string& name,
                                   const std::string& folder) {
  CsvReader reader(text);
  const Cells names = reader.nextLine();
  const auto site = columnOf(names, "site"), file = columnOf(names, "file");
  const auto robot = columnOf(names, "robot"), time = columnOf(names, "time");
  if (!site || !file)
    throw DataError(name +
                    ": has no columns 'site' and 'file': name the columns in its first line");
  std::vector<ListedRun> runs;
  while (!reader.isAtEnd()) {
    const Cells cells = reader.nextLine();
    if (cells.size() == 1 && cells[0].empty()) continue;
    const auto cell = [&](std::optional<std::size_t> column) {
      return column && *column < cells.size() ? cells[*column] : std::string();
    };
    const std::string where = name + ": line " + std::to_string(reader.line());
    if (cell(site).empty() || cell(file).empty())
      throw DataError(where + " has no site or no file: fill it in, or take the line out");
    ListedRun run{cell(site), "", cell(robot).empty() ? "robot" : cell(robot), {}};
    run.file = std::filesystem::absolute(std::filesystem::path(folder) / cell(file))
                   .lexically_normal()
                   .string();
    if (!cell(time).empty() && !(run.time = parseTime(cell(time))))
      throw DataError(where + ": '" + cell(time) + "' is not a time: give 2026-11-22T03:00");
    runs.push_back(run);
  }
  return runs;
}

}  // namespace roomgraph
