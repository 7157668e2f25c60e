#include "roomgraph/compare/compare_maps.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/compare/compare_related.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/relate/estimate_scale.h"
#include "roomgraph/scans/load_keyframes.h"

namespace roomgraph {

FieldTable describe(CompareMapsOptions& options) {
  FieldTable table = describe(options.extract);
  table.flag("compare", "aligned", options.compare.areAligned,
             "All maps are in one frame already.");
  table.flag("compare", "estimate_scale", options.estimatesScale,
             "Bare pictures are read at the scale at which they fit the other maps.");
  table.number("run_score", "scale", options.compare.scoreScale, "m", 0.001, 1000,
               "The map error at which the score is 37, which is 100 / e.");
  table.number("run_score", "min_share", options.compare.leastShare, "", 0, 1,
               "Share of its walls that another map must have, too, for a score that counts.");
  table.number("site_breaks", "min_shift", options.compare.breakShift, "m", 0.05, 100,
               "A run whose map jumps by this or more breaks there.");
  table.number("site_breaks", "min_rotation", options.compare.breakRotation, "rad", 0.005, 4,
               "The same where it turns by this or more.");
  return table;
}

void setUsed(const Comparison& comparison, FieldTable& table) {
  for (const UsedOption& used : comparison.options)
    for (const Field& field : table.fields())
      if (field.section == used.section && field.name == used.name)
        table.set(used.section, used.name, used.value);
}

std::vector<UsedOption> usedOptions(CompareMapsOptions options) {
  std::vector<UsedOption> used;
  const FieldTable table = describe(options);
  for (const Field& field : table.fields())
    used.push_back({field.section, field.name, valueText(field), field.unit, field.sentence});
  used.push_back({"compare", "reference",
                  std::filesystem::path(options.reference).filename().string(), "",
                  "The map that all runs are measured against; empty for none."});
  return used;
}

Comparison compareMaps(const ReadRuns& read, const CompareMapsOptions& options) {
  CompareRunsOptions compare = options.compare;
  compare.reference = read.reference;
  Comparison result = compareRelated(
      read.runs, relateRuns(read.runs, relateOptionsOf(compare), compare.forEach, compare.kept),
      compare);
  result.leftOut.insert(result.leftOut.end(), read.leftOut.begin(), read.leftOut.end());
  std::sort(result.leftOut.begin(), result.leftOut.end(),
            [](const LeftOutRun& l, const LeftOutRun& r) { return l.name < r.name; });
  result.options = usedOptions(options);
  return result;
}

std::vector<Run> readMapsOf(const Comparison& comparison, const std::vector<std::string>& files) {
  CompareMapsOptions used;
  FieldTable table = describe(used);
  setUsed(comparison, table);
  const ExtractOptions& options = used.extract;
  std::vector<Run> runs;
  for (const std::string& file : files) {
    GreyMap map = loadGrid(file, options.loadGrid);
    for (const ComparedRun& compared : comparison.runs) {
      if (compared.sha256 != map.source.sha256) continue;
      if (compared.isScaleEstimated)
        map.frame = rescaled({map.frame, {}}, compared.resolution).frame;
      Run run;
      run.name = compared.name, run.file = compared.file, run.sha256 = compared.sha256;
      run.map = mapForAlignment(binarize(map, options.binarize), {});
      run.scans = scanWalls(loadKeyframes(file, options.loadGrid));
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

Comparison compareMaps(const std::vector<std::string>& files, const CompareMapsOptions& options) {
  return compareMaps(readRuns(files, options), options);
}

}  // namespace roomgraph
