#include <algorithm>
#include <chrono>
#include <filesystem>

#include "View.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/scans/load_keyframes.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;
using Say = std::function<void(const std::string&)>;

constexpr int kWallsOfScan = 400;  // one scan is drawn at a time

bool isComparison(const std::string& file) { return fs::path(file).extension() == ".json"; }

/** The maps of a comparison that were not named: files of their names near by. */
void addNearby(const Comparison& comparison, const fs::path& folder,
               std::vector<std::string>& files) {
  std::error_code error;
  for (const ComparedRun& run : comparison.runs)
    for (const fs::path& place : {folder / run.file, folder / ".." / run.file, fs::path(run.file)})
      if (fs::is_regular_file(place, error)) files.push_back(place.string());
}

View viewOfComparison(std::vector<std::string> files, const Say& say) {
  View view;
  const std::string name = files.front();
  files.erase(files.begin());
  view.comparison = readComparison(name);
  addNearby(view.comparison, fs::path(name).parent_path(), files);
  for (const std::string& file : files)  // one by one, to know whose scans they are
    for (Run& run : readMapsOf(view.comparison, {file})) {
      if (view.runNamed(run.name)) continue;
      run.scans = scanWalls(loadKeyframes(file, LoadGridOptions()), kWallsOfScan);
      view.runs.push_back(std::move(run));
    }
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
  ReadRuns read = readRuns(files, compare);
  View view;
  view.comparison = compareMaps(read, compare);
  view.runs = std::move(read.runs);
  return view;
}

View viewOfMap(const std::string& file, const ExtractOptions& options) {
  View view;
  view.options = options;
  view.map = loadGrid(file, options.loadGrid);
  Run run;
  run.name = mapStem(file), run.file = file;
  run.scans = scanWalls(loadKeyframes(file, options.loadGrid), kWallsOfScan);
  ComparedRun alone;
  alone.name = run.name, alone.file = file;
  for (const ScanWalls& scan : run.scans)
    alone.path.push_back({scan.keyFrame, scan.time, scan.pose, std::nullopt});
  view.comparison.runs = {alone};
  view.runs.push_back(std::move(run));
  extractAgain(view);
  return view;
}

}  // namespace

const Run* View::runNamed(const std::string& name) const {
  const auto found =
      std::find_if(runs.begin(), runs.end(), [&](const Run& run) { return run.name == name; });
  return found == runs.end() ? nullptr : &*found;
}

View loadView(const std::vector<std::string>& files, const ExtractOptions& options,
              const Say& say) {
  View view = isComparison(files.front()) ? viewOfComparison(files, say)
              : files.size() > 1          ? viewOfRuns(files, options, say)
                                          : viewOfMap(files.front(), options);
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
