#include "simulated_site.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "CsvTable.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

std::optional<MapBreak> breakIn(const CsvTable& table, std::size_t row) {
  if (table.text(row, "cut_x").empty()) return std::nullopt;
  return MapBreak{table.text(row, "run"),
                  {table.number(row, "cut_x"), table.number(row, "cut_y")},
                  table.number(row, "jump_deg") * M_PI / 180,
                  std::hypot(table.number(row, "jump_x"), table.number(row, "jump_y")),
                  {},
                  {}};
}

/** All columns that were set for a run, but the seed. */
std::string settingsIn(const CsvTable& table, std::size_t row) {
  std::string all;
  for (const char* column :
       {"backend", "trajectory", "odo_noise", "fov_deg", "max_range_m", "laser_noise_m"})
    all += table.text(row, column) + ' ';
  return all;
}

}  // namespace

std::vector<std::string> simulatedSites(const std::string& data, const std::string& only) {
  std::vector<std::string> folders;
  if (fs::is_directory(data))
    for (const auto& entry : fs::directory_iterator(data))
      if (fs::exists(entry.path() / "truth.csv") &&
          entry.path().filename().string().find(only) != std::string::npos)
        folders.push_back(entry.path().string());
  if (folders.empty())
    throw DataError(data + ": holds no folder with a truth.csv; name that of the simulated runs");
  std::sort(folders.begin(), folders.end());
  return folders;
}

SimulatedSite readSite(const std::string& folder, const std::string& extension) {
  SimulatedSite site;
  site.name = fs::path(folder).filename().string();
  const CsvTable table((fs::path(folder) / "truth.csv").string());
  std::map<std::string, std::size_t> rowOf;
  std::vector<std::string> files;
  for (std::size_t i = 0; i < table.size(); ++i) {
    rowOf[table.text(i, "run")] = i;
    files.push_back((fs::path(folder) / (table.text(i, "run") + extension)).string());
  }
  CompareMapsOptions options;
  options.onUnread = [](const LeftOutRun& run) { throw DataError(run.file + ": " + run.reason); };
  site.runs = readRuns(files, options).runs;
  for (const Run& run : site.runs) {
    const std::size_t row = rowOf.at(run.name);
    site.truth.push_back(table.number(row, "map_rms_m"));
    site.toTruth.push_back(table.pose(row, "A"));
    site.breaks.push_back(breakIn(table, row));
    site.settings.push_back(settingsIn(table, row));
  }
  site.related = relateRuns(site.runs, {}, oneByOne);
  return site;
}

}  // namespace roomgraph
