#include "more_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include "file_authors.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/read_recording.h"
#include "roomgraph/mrpt_plugin/fault_files.h"
#include "roomgraph/mrpt_plugin/mrpt_files.h"
#include "roomgraph/relate/estimate_scale.h"
#include "roomgraph/report/evo_files.h"
#include "roomgraph/report/faults.h"
#include "roomgraph/report/site_json.h"
#include "roomgraph/scans/place_scans.h"
#include "terminal.h"

namespace roomgraph {
namespace {

PlacedScans scansOf(const std::string& file, const LoadGridOptions& reading) {
  auto recording = readRecording(file);
  if (!recording) return {};
  return placeScans(std::move(*recording), reading);
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

/** What the files of each run begin with: "comparison.RUN". */
std::vector<std::string> stemsOf(const std::vector<std::string>& runs) {
  std::vector<std::string> stems;
  std::set<std::string> taken;
  for (const std::string& run : runs) stems.push_back("comparison." + fileWord(run, taken));
  return stems;
}

std::vector<std::string> stemsOf(const Comparison& comparison) {
  return stemsOf(mapped(comparison.runs, &ComparedRun::name));
}

constexpr const char* kTrajectoryKinds[] = {".tum", ".evo.zip"};
constexpr const char* kSiteMapKinds[] = {".yaml", ".pgm", ".pose.yaml"};
constexpr char kSession[] = "comparison.maps.toml";

/** The run's own cells; the wall maps that are compared are coarser. */
Grid gridOf(const ComparedRun& run, const ExtractOptions& options) {
  Grid grid = binarize(loadGrid(run.file, options.loadGrid), options.binarize);
  if (run.isScaleEstimated) grid = rescaled(std::move(grid), run.resolution);
  return grid;
}

}  // namespace

void addBreakFiles(const Comparison& comparison, const std::vector<Run>& runs,
                   const LoadGridOptions& reading, FolderFiles& files) {
  std::map<std::string, std::vector<PlacedScan>> read;  // by run
  for (const Fault& fault : faultsOf(comparison)) {
    const Run* run = findRun(runs, fault.run);
    const ComparedRun* placed = findRun(comparison.runs, fault.run);
    if (!fault.keyFrame || !run || !placed) continue;
    const auto [known, isNew] = read.try_emplace(fault.run);
    if (isNew) known->second = scansOf(run->file, reading).scans;
    const std::vector<PlacedScan>& scans = known->second;
    const std::string stem = "comparison." + fault.name();
    for (const bool isUntorn : {false, true})
      files.add(stem + (isUntorn ? ".untorn.rawlog" : ".rawlog"),
                rawlogBytes(scansAtFault(fault, placed->pose, scans, isUntorn)));
    files.add(stem + ".3Dscene", faultSceneBytes(comparison, fault, runs));
  }
}

void addCheckLogs(const RunCheck& check, const LoadGridOptions& reading, const std::string& stem,
                  FolderFiles& files) {
  const std::vector<Fault> faults = faultsOf(check);
  if (faults.empty()) return;
  const std::vector<PlacedScan> scans = scansOf(check.file, reading).scans;
  for (const Fault& fault : faults) {
    const std::string name = stem + "." + fault.name();
    files.add(name + ".rawlog", rawlogBytes(scansAtFault(fault, {}, scans, false)));
    if (fault.mend)
      files.add(name + ".untorn.rawlog", rawlogBytes(scansAtFault(fault, {}, scans, true)));
  }
}

std::string scanLog(const std::string& file, const LoadGridOptions& reading,
                    const KeyFrameStretch& stretch) {
  PlacedScans placed = scansOf(file, reading);
  printWarnings(file, placed.notes);
  std::vector<PlacedScan>& scans = placed.scans;
  if (scans.empty()) throw DataError(file + ": has no key frames: give a simplemap with scans");
  const std::size_t last = scans.back().keyFrame, to = stretch.to.value_or(last);
  if (std::max(stretch.from, to) > last)
    throw DataError(file + ": its last key frame is " + std::to_string(last) +
                    ": choose --from and --to up to that");
  eraseIf(scans, [&](const PlacedScan& scan) {
    return scan.keyFrame < stretch.from || scan.keyFrame > to;
  });
  return rawlogBytes(scans);
}

SiteFile readSite(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  return parseSiteJson(readFile(file), file);
}

std::vector<std::string> trajectoryNames(const std::vector<std::string>& runs) {
  std::vector<std::string> names;
  for (const std::string& stem : stemsOf(runs))
    for (const char* kind : kTrajectoryKinds) names.push_back(stem + kind);
  return names;
}

std::vector<std::string> siteMapNames(const std::vector<std::string>& runs) {
  std::vector<std::string> names{kSession};
  for (const std::string& stem : stemsOf(runs))
    for (const char* kind : kSiteMapKinds) names.push_back(stem + kind);
  return names;
}

void addTrajectories(const Comparison& comparison, FolderFiles& files) {
  const std::vector<std::string> stems = stemsOf(comparison);
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const ComparedRun& run = comparison.runs[i];
    const auto [tum, evo] = kTrajectoryKinds;
    if (const std::string path = pathTum(run); !path.empty())
      files.add(stems[i] + tum, withAuthor(path));
    const std::string errors = evoResult(run, stems[i].substr(stems[i].find('.') + 1));
    if (!errors.empty()) files.add(stems[i] + evo, errors);
  }
}

void addSiteMaps(const Comparison& comparison, const ExtractOptions& options, FolderFiles& files) {
  const std::vector<std::string> stems = stemsOf(comparison);
  std::vector<SessionMap> session;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const ComparedRun& run = comparison.runs[i];
    const Grid grid = gridOf(run, options);
    const auto [yaml, picture, pose] = kSiteMapKinds;
    const std::string &stem = stems[i], word = stem.substr(stem.find('.') + 1);
    session.push_back({stem + yaml, stem + picture, grid.frame, run.pose});
    files.add(stem + yaml, rosMapYaml(grid.frame, stem + picture, run.pose));
    files.add(stem + picture, mapPgm(grid));
    files.add(stem + pose, withAuthor(mapsPoseYaml(run.pose, word)));
  }
  files.add(kSession, mapsSession(session));
}

}  // namespace roomgraph
