#include <algorithm>
#include <chrono>
#include <filesystem>

#include "View.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/upright_turn.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;
using Say = std::function<void(const std::string&)>;

constexpr int kWallsOfScan = 400;  // one scan is drawn at a time

/** Graphs are JSON as well: who reads maps knows what opens them. */
bool isComparison(const std::string& file) {
  if (fs::path(file).extension() != ".json") return false;
  return CheckedFile(file).head().text().find("\"roomgraph/comparison\"") != std::string::npos;
}

/** Adds the runs of a map file to the view; says why where there is none. */
void addMap(const std::string& file, View& view, const std::string& comparison, const Say& say) {
  try {
    std::vector<Run> runs = readMapsOf(view.comparison, {file}, kWallsOfScan);
    if (runs.empty()) say(file + ": is none of the maps of " + comparison + ": not drawn");
    for (Run& run : runs)
      if (!view.runNamed(run.name)) view.runs.push_back(std::move(run));
  } catch (const DataError& error) {
    say(error.what());  // the others can be looked at
  }
}

/** The maps of a comparison that were not named: files of their names near by. */
void addNearby(const std::string& comparison, View& view, const Say& say) {
  for (const ComparedRun& run : view.comparison.runs)
    for (const std::string& file : mapsNear(run, comparison))
      if (!view.runNamed(run.name)) addMap(file, view, comparison, say);
}

View viewOfComparison(const std::string& name, const std::vector<std::string>& maps,
                      const Say& say) {
  View view;
  view.comparison = readComparison(name);
  for (const std::string& file : maps) addMap(file, view, name, say);
  addNearby(name, view, say);
  for (const ComparedRun& run : view.comparison.runs)
    if (!view.runNamed(run.name))
      say(name + ": the map " + run.file + " is not drawn: name it behind the comparison");
  return view;
}

View viewOfRuns(const std::vector<std::string>& files, const ExtractOptions& options,
                const Say& say) {
  CompareMapsOptions compare;
  compare.extract = options;
  compare.onUnread = [&](const LeftOutRun& run) { say(run.file + ": " + run.reason); };
  compare.onNote = [&](const std::string& file, const Note& note) {
    if (note.isWarning) say(file + ": note: " + note.text);
  };
  ReadRuns read = readRuns(files, compare);
  View view;
  view.comparison = compareMaps(read, compare);
  for (const LeftOutRun& run : view.comparison.leftOut)
    if (run.isOtherSite) say(run.file + ": " + run.reason + ": not drawn");
  view.runs = std::move(read.runs);
  return view;
}

/** What the one run of the view tells of itself: its faults, and how far each key frame is off. */
void addCheck(const std::vector<Keyframe>& keyframes, View& view) {
  Run run;
  run.name = view.runs.front().name, run.scans = scanWalls(keyframes);
  run.map = wallMap(view.stages->grid);
  if (run.scans.empty() || run.map.walls.empty()) return;
  const RunCheck check = checkRun(run);
  view.faults = faultsOf(check);
  auto& path = view.comparison.runs.front().path;
  for (std::size_t k = 0; k < std::min(path.size(), check.path.size()); ++k)
    if (check.selfError && check.path[k].isSeenTwice) path[k].error = check.path[k].error;
}

View viewOfMap(const std::string& file, const ExtractOptions& options) {
  View view;
  view.options = options;
  LoadedMap read = loadMap(file, options.loadGrid);
  view.map = std::move(read.map);
  extractAgain(view);
  Run run;
  run.name = mapStem(file), run.file = file;
  run.scans = scanWalls(read.keyframes, kWallsOfScan);
  ComparedRun alone;
  alone.name = run.name, alone.file = file;
  for (const ScanWalls& scan : run.scans)
    alone.path.push_back({scan.keyFrame, scan.time, scan.pose, std::nullopt});
  view.comparison.runs = {std::move(alone)};
  view.runs.push_back(std::move(run));
  addCheck(read.keyframes, view);
  return view;
}

}  // namespace

View loadView(const std::vector<std::string>& files, const ExtractOptions& options,
              const Say& say) {
  std::vector<std::string> maps = files;
  const auto comparison = std::find_if(maps.begin(), maps.end(), isComparison);
  const std::string name = comparison == maps.end() ? "" : *comparison;
  if (comparison != maps.end()) maps.erase(comparison);
  if (!name.empty() && anyOf(maps, isComparison))
    throw UsageError(name + ": name one comparison, and its maps");
  View view = !name.empty()     ? viewOfComparison(name, maps, say)
              : maps.size() > 1 ? viewOfRuns(maps, options, say)
                                : viewOfMap(maps.front(), options);
  if (!view.graph) {
    view.turn = uprightTurn(view.comparison, view.runs);
    view.faults = faultsOf(view.comparison);
  }
  if (view.comparison.runs.empty())
    throw DataError(files.front() + ": has no run to look at: name maps, or another comparison");
  return view;
}

void extractAgain(View& view) {
  const auto start = std::chrono::steady_clock::now();
  view.stages = view.stages ? extractAgain(std::move(*view.stages), *view.map, view.options)
                            : extract(*view.map, view.options);
  view.graph = CRoomGraph(*view.stages);
  view.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace roomgraph
