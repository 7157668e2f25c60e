#include "roomgraph/compare/compare_maps.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/relate/estimate_scale.h"

namespace roomgraph {

Comparison compareMaps(const ReadRuns& read, const CompareMapsOptions& options) {
  CompareRunsOptions compare = options.compare;
  compare.reference = read.reference;
  Comparison result = compareRuns(read.runs, compare);
  result.leftOut.insert(result.leftOut.end(), read.leftOut.begin(), read.leftOut.end());
  sortBy(result.leftOut, &LeftOutRun::name);
  result.options = usedOptions(options);
  return result;
}

std::vector<Run> readMapsOf(const Comparison& comparison, const std::vector<std::string>& files,
                            int wallsPerScan) {
  CompareMapsOptions used;
  FieldTable table = describe(used);
  setUsed(comparison, table);
  const ExtractOptions& options = used.extract;
  std::vector<Run> runs;
  for (const std::string& file : files) {
    auto [map, keyframes] = loadMap(file, options.loadGrid);
    for (const ComparedRun& compared : comparison.runs) {
      if (compared.sha256 != map.source.sha256) continue;
      if (compared.isScaleEstimated)
        map.frame = rescaled({map.frame, {}}, compared.resolution).frame;
      Run run;
      run.name = compared.name, run.file = compared.file, run.sha256 = compared.sha256;
      run.map = wallMap(binarize(map, options.binarize));
      run.scans = scanWalls(keyframes, wallsPerScan);
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

std::vector<std::string> mapsNear(const ComparedRun& run, const std::string& comparisonFile) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(comparisonFile).parent_path();
  std::vector<std::string> files;
  std::error_code error;
  for (const fs::path& place :
       {folder / run.relativePath, folder / run.file, folder / ".." / run.file, fs::path(run.file)})
    if (fs::is_regular_file(place, error)) files.push_back(place.string());
  return files;
}

Comparison compareMaps(const std::vector<std::string>& files, const CompareMapsOptions& options) {
  return compareMaps(readRuns(files, options), options);
}

}  // namespace roomgraph
