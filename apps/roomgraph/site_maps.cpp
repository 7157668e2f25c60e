#include "site_maps.h"

#include <set>

#include "file_word.h"
#include "roomgraph/graph_files/maps_viewer.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/relate/estimate_scale.h"
#include "stage_result.h"

namespace roomgraph {
namespace {

/** The run's own cells; the wall maps that are compared are coarser. */
Grid gridOf(const ComparedRun& run, const ExtractOptions& options) {
  Grid grid = binarize(loadGrid(run.file, options.loadGrid), options.binarize);
  if (run.isScaleEstimated) grid = rescaled(std::move(grid), run.resolution);
  return grid;
}

}  // namespace

std::vector<std::string> addSiteMaps(const Comparison& comparison, const ExtractOptions& options,
                                     const std::filesystem::path& folder, StagedFiles& staged) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name, const std::string& bytes) {
    names.push_back(stageResult(comparison, folder, name, bytes, staged));
  };
  std::set<std::string> taken;
  std::vector<SessionMap> session;
  for (const ComparedRun& run : comparison.runs) {
    const Grid grid = gridOf(run, options);
    const std::string word = fileWord(run.name, taken), stem = "comparison." + word;
    session.push_back({stem + ".yaml", stem + ".pgm", grid.frame, run.pose});
    add(stem + ".yaml", rosMapYaml(grid.frame, stem + ".pgm", run.pose));
    add(stem + ".pgm", mapPgm(grid));
    add(stem + ".pose.yaml", mapsPoseYaml(run.pose, word));
  }
  add("comparison.maps.toml", mapsSession(session));
  return names;
}

}  // namespace roomgraph
