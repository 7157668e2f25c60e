#include "site_files.h"

#include <cctype>
#include <set>

#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/graph_files/maps_viewer.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/relate/estimate_scale.h"
#include "roomgraph/report/evo_files.h"
#include "roomgraph/report/site_json.h"

namespace roomgraph {
namespace {

/** Stages a file of a comparison, and returns its name with the folder.
 *  @throws UsageError where it would replace one of the maps that are compared. */
std::string stageResult(const Comparison& comparison, const std::filesystem::path& folder,
                        const std::string& name, const std::string& bytes, StagedFiles& staged) {
  std::string file = (folder / name).string();
  for (const ComparedRun& run : comparison.runs)
    if (areSameFile(file, run.file))
      throw UsageError(file + ": would replace a map: choose another folder with --output");
  staged.add(file, bytes);
  return file;
}

/** The name of a run as part of that of a file, another one than those that are taken: names may be
 *  paths, and YAML and TOML have signs of their own. */
std::string fileWord(const std::string& name, std::set<std::string>& taken) {
  std::string word;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    word += byte >= 0x80 || std::isalnum(byte) || c == '-' || c == '.' ? c : '_';
  }
  while (!taken.insert(word).second) word += '_';
  return word;
}

/** The run's own cells; the wall maps that are compared are coarser. */
Grid gridOf(const ComparedRun& run, const ExtractOptions& options) {
  Grid grid = binarize(loadGrid(run.file, options.loadGrid), options.binarize);
  if (run.isScaleEstimated) grid = rescaled(std::move(grid), run.resolution);
  return grid;
}

}  // namespace

SiteFile readSite(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  return parseSiteJson(readFile(file), file);
}

std::vector<std::string> addTrajectories(const Comparison& comparison,
                                         const std::filesystem::path& folder, StagedFiles& staged) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name, const std::string& bytes) {
    if (!bytes.empty()) names.push_back(stageResult(comparison, folder, name, bytes, staged));
  };
  std::set<std::string> taken;
  for (const ComparedRun& run : comparison.runs) {
    const std::string word = fileWord(run.name, taken);
    add("comparison." + word + ".tum", pathTum(run));
    add("comparison." + word + ".evo.zip", evoResult(run, word));
  }
  return names;
}

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
