#include "merge_site.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "ResultFolder.h"
#include "commands.h"
#include "more_files.h"
#include "output_formats.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/check/find_refuted.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/images/png_bytes.h"
#include "roomgraph/ledger/name_rooms.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/mrpt_plugin/mrpt_files.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/repair/key_frame_moves.h"
#include "roomgraph/repair/merge_runs.h"
#include "roomgraph/repair/repair_runs.h"
#include "roomgraph/report/site_json.h"
#include "roomgraph/scans/read_simplemap.h"
#include "roomgraph/scans/rewrite_simplemap.h"
#include "run_in_order.h"
#include "terminal.h"

namespace roomgraph {
namespace {

constexpr const char* kGridmap = "site.gridmap.gz";
constexpr const char* kGraphFormats = "json,svg,geojson,osm";
const std::string kGraphStem = "site.graph.";

struct Merging {
  std::vector<MergedRun> runs;
  std::vector<const Run*> from;
  std::vector<RepairedRun> poses;  ///< in the frame of the site
  std::vector<std::string> leftOut;
};

MergedRun mergedRun(const Run& run, const std::vector<Transform2D>& real,
                    const LoadGridOptions& reading) {
  MergedRun merged;
  merged.name = run.name;
  merged.scans = loadMap(run.file, reading).keyframes;
  if (merged.scans.size() != real.size())
    throw DataError(run.file + ": has changed since it was read: start again");
  for (std::size_t k = 0; k < real.size(); ++k) {
    merged.drawn.push_back(merged.scans[k].pose);
    merged.scans[k].pose = real[k];
    if (!merged.time) merged.time = merged.scans[k].time;
  }
  return merged;
}

Merging chooseRuns(const SolvedRuns& runs, const LoadGridOptions& reading, const ForEach& forEach) {
  Merging merging;
  const RealPoses real = rejoinPieces(runs.solved);
  const auto refuted = findRefuted(runs.solved.site, runs.solved.consensus, forEach);
  for (std::size_t i = 0; i < real.size(); ++i) {
    const Run& run = *runs.solved.site.runs[i];
    if (run.scans.empty()) {
      merging.leftOut.push_back(run.name + ": has no scans");
    } else if (!isTrusted(runs.solved.consensus.errorOf(i))) {
      merging.leftOut.push_back(run.name + ": others have not seen enough of it");
    } else if (fitsInTwoWays(runs.solved.consensus.errorOf(i))) {
      merging.leftOut.push_back(run.name + ": fits the others in two ways");
    } else if (refuted[i]) {
      merging.leftOut.push_back(run.name + ": " + weldedText(*refuted[i]));
    } else {
      merging.runs.push_back(mergedRun(run, real[i], reading));
      merging.from.push_back(&run);
      RepairedRun& inSite = merging.poses.emplace_back();
      inSite.state = RepairState::mended, inSite.poses = real[i];
    }
  }
  if (merging.runs.empty())
    throw DataError("merge: there is no run with scans that others confirm: add runs of the site");
  return merging;
}

void tellLeftOut(const MergedMap& map, Merging& merging) {
  for (std::size_t r = 0; r < merging.runs.size(); ++r) {
    const std::size_t count = map.leftOut[r].size(), all = merging.runs[r].scans.size();
    if (count == all)
      merging.leftOut.push_back(merging.runs[r].name + ": contradicts what the others see");
    else if (count > 0)
      merging.leftOut.push_back(formatted("%s: %zu of its %zu scans contradict what the others see",
                                          merging.runs[r].name.c_str(), count, all));
  }
}

/** All key frames that were merged in one map, and those beside them that have no scan. */
std::string siteSimplemap(const Merging& merging, const MergedMap& map) {
  std::vector<SimplemapPart> parts;
  for (std::size_t r = 0; r < merging.runs.size(); ++r) {
    CheckedFile file(merging.from[r]->file);
    SimplemapPart& part = parts.emplace_back();
    part.recording = readSimplemap(file);
    part.content = movePoses(file.content(), part.recording,
                             keyFrameMoves(*merging.from[r], merging.poses[r], part.recording));
    // From here on only the places of their bytes are needed, and there may be gigabytes.
    for (Recording::Frame& frame : part.recording.frames) frame.scans = {}, frame.clouds = {};
    part.recording.bytes.reset();
    std::vector<bool> isLeftOut(part.recording.frames.size());
    for (const std::size_t k : map.leftOut[r]) isLeftOut.at(merging.runs[r].scans[k].number) = true;
    const bool isWhollyOut = map.leftOut[r].size() == merging.runs[r].scans.size();
    for (std::size_t k = 0; k < isLeftOut.size() && !isWhollyOut; ++k)
      if (!isLeftOut[k]) part.frames.push_back(k);
  }
  return packedMap(joinSimplemaps(parts), Compression::gzip);
}

/** How many runs have seen each cell, as grey from 0 on. */
std::string runsPng(const MergedMap& map) {
  return pngBytes(std::vector<std::uint16_t>(map.runs.begin(), map.runs.end()), map.map.frame.width,
                  map.map.frame.height);
}

/** How many days before the latest run each cell was seen last, and 1 more; 0 for not known. */
std::string agePng(const MergedMap& map) {
  std::vector<std::uint16_t> levels;
  for (const float days : map.time)
    levels.push_back(std::uint16_t(std::clamp(std::floor(days) + 1, 0.0F, 65535.0F)));
  return pngBytes(levels, map.map.frame.width, map.map.frame.height);
}

/** The rooms that are known of the site; nothing where nobody asks for names. */
std::optional<SiteFile> knownRooms(const MergeArguments& arguments) {
  if (arguments.known) return arguments.known;
  if (arguments.names.empty()) return std::nullopt;
  return readSite(arguments.names);
}

/** The graph of the site, with the names of its rooms. */
void addGraph(const Stages& stages, const MergeArguments& arguments, FolderFiles& files) {
  std::vector<std::string> names;
  if (std::optional<SiteFile> known = knownRooms(arguments)) {
    const std::string& source = arguments.names.empty() ? "archive" : arguments.names;
    NamedAreas named = nameAreas(stages.areas, std::move(*known), source);
    names = std::move(named.names);
    if (!arguments.names.empty()) files.staged.add(arguments.names, siteJson(named.file));
  }
  for (const OutputFormat& format : parseFormats(kGraphFormats))
    files.add(kGraphStem + format.extension, format.bytes(stages, {names, {}}));
}

/** Throws where a result would take the place of what is not to be replaced. */
void checkFiles(const MergeArguments& arguments) {
  CallFiles files = filesReadBy(arguments.files, arguments.options);
  files.reads(arguments.reference);
  files.updates("--names", arguments.names);
  for (const char* name :
       {"site.simplemap.gz", kGridmap, "site.yaml", "site.pgm", "site.runs.png", "site.age.png"})
    files.writes(inFolder(arguments.folder, name));
  for (const OutputFormat& format : parseFormats(kGraphFormats))
    files.writes(inFolder(arguments.folder, kGraphStem + format.extension));
}

}  // namespace

void declareMerging(MergeArguments& arguments, CLI::App& app) {
  app.add_flag("--latest", arguments.prefersLatest,
               "Let each run count twice as much as the one made before it.");
  declareSite(
      arguments,
      "site.simplemap.gz, site.gridmap.gz, site.yaml with site.pgm, site.runs.png (how many "
      "runs have seen each cell), site.age.png (when it was seen last), and the graph with "
      "rooms as site.graph.json, .svg, .geojson and .osm",
      app);
}

int mergeSite(const MergeArguments& arguments) {
  if (arguments.files.size() < 2)
    throw UsageError("merge: one run is a map of its own: name two or more");
  checkFiles(arguments);
  const ResultFolder folder(arguments.folder);
  const CompareMapsOptions options = toCompareOptions(arguments.options);
  const auto runs = solvedRunsOf(arguments);
  const RunningArguments& running = arguments.running;
  const ForEach forEach = onThreads(running.threads, !running.isQuiet);
  Merging merging = chooseRuns(*runs, options.extract.loadGrid, forEach);
  printUnplaced(*runs);
  MergeOptions how;
  how.resolution = options.extract.loadGrid.resolution, how.prefersLatest = arguments.prefersLatest;
  const MergedMap map = mergeRuns(merging.runs, how, forEach);
  tellLeftOut(map, merging);
  Stages stages = extract(map.map, options.extract);
  const std::string gridmap = gridmapBytes(map.map, stages.grid);
  stages.source = {kGridmap, "gridmap", sha256Of(viewOf(gridmap)), ""};
  FolderFiles files{arguments.folder};
  files.add("site.simplemap.gz", siteSimplemap(merging, map));
  files.add(kGridmap, gridmap);
  files.add("site.yaml", rosMapYaml(stages.grid.frame, "site.pgm"));
  files.add("site.pgm", mapPgm(stages.grid));
  files.add("site.runs.png", runsPng(map));
  files.add("site.age.png", agePng(map));
  addGraph(stages, arguments, files);
  files.staged.commit();
  for (const std::string& text : merging.leftOut) printError(text + ": left out");
  if (running.isQuiet) return runs->exitCode();
  for (const std::string& name : files.names) print(printable(name) + "\n");
  return runs->exitCode();
}

std::function<int()> mergeCommand(CLI::App& app) {
  const auto arguments = std::make_shared<MergeArguments>();
  addArgument(app, "RUN", arguments->files, "Simplemaps of one site, each of a drive.");
  addOption(app, "--names FILE", arguments->names,
            "JSON file that keeps the ids and names of the site's rooms, as for 'roomgraph "
            "compare': the graph has them.");
  declareMerging(*arguments, app);
  return [arguments] { return mergeSite(*arguments); };
}

}  // namespace roomgraph
