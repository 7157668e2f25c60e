#include <algorithm>
#include <memory>

#include "commands.h"
#include "file_authors.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/base/compressed.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/mrpt_plugin/mrpt_files.h"
#include "roomgraph/page/repair_page.h"
#include "roomgraph/repair/key_frame_moves.h"
#include "roomgraph/repair/loop_constraints.h"
#include "roomgraph/repair/repair_runs.h"
#include "roomgraph/scans/StoredPose.h"
#include "site_runs.h"
#include "terminal.h"

namespace roomgraph {
namespace {

constexpr char kPage[] = "repair.html", kPoseGraph[] = "site.g2o";

struct RepairArguments {
  SiteArguments site;
  std::vector<std::string> only;
  std::string format;
};

void addRun(const Run& run, const RepairedRun& repaired, const std::string& folder,
            StagedFiles& staged) {
  CheckedFile file(run.file);
  const StoredPoses stored = readStoredPoses(file);
  const std::vector<PoseMove> moves = keyFrameMoves(run, repaired, stored);
  const std::string content = movePoses(file.content(), file.name(), stored, moves);
  const auto path = [&](const std::string& name) { return inFolder(folder, name); };
  const std::string map = packedMap(content, file.compression());
  staged.add(path(repairedName(run.file)), map);
  staged.add(path(mapStem(run.file) + ".repaired.tum"),
             withAuthor(hashLine(map) + trajectoryTum(stored, moves)));
}

/** The constraints for MOLA are of all runs, mended or not: they are for another back end. */
void addConstraints(const Run& run, const std::vector<Transform2D>& real, const std::string& folder,
                    StagedFiles& staged) {
  const std::string name = mapStem(run.file) + ".loop_constraints.yaml";
  staged.add(inFolder(folder, name), withAuthor(molaConstraints(loopConstraints(run, real))));
}

/** The grids of what was mended, made of the simplemaps that are written now. */
void writeGrids(const std::vector<std::string>& files, const SiteArguments& site) {
  const ExtractOptions options = toCompareOptions(site.options).extract;
  StagedFiles staged;
  for (const std::string& file : files) {
    const std::string stem = mapStem(file);
    const auto path = [&](const char* extension) {
      return outputFile(site.folder, file, extension);
    };
    const std::string name = inFolder(site.folder, repairedName(file));
    const GreyMap map = loadGrid(name, options.loadGrid);
    const Grid grid = binarize(map, options.binarize);
    staged.add(path("repaired.gridmap.gz"), gridmapBytes(map, grid));
    staged.add(path("repaired.pgm"), mapPgm(grid));
    staged.add(path("repaired.yaml"), rosMapYaml(grid.frame, stem + ".repaired.pgm"));
  }
  staged.commit();
}

void check(const RepairArguments& arguments) {
  const SiteArguments& site = arguments.site;
  if (!arguments.format.empty() && arguments.format != "mola")
    throw UsageError("repair: there is no format '" + arguments.format + "': --format takes mola");
  std::vector<std::string> extensions;
  for (const char* kind : {"tum", "gridmap.gz", "yaml", "pgm"})
    extensions.push_back(std::string("repaired.") + kind);
  if (!arguments.format.empty()) extensions.emplace_back("loop_constraints.yaml");
  CallFiles files = filesReadBy(site.files, site.options);
  files.reads(site.reference);
  for (const std::string& run : site.files)
    files.writes(inFolder(site.folder, repairedName(run)), run);
  files.writesOfEach(site.files, site.folder, extensions);
  for (const char* name : {kPage, kPoseGraph}) files.writes(inFolder(site.folder, name));
}

bool isAskedFor(const Run& run, const RepairArguments& arguments) {
  const std::vector<std::string>& only = arguments.only;
  return only.empty() || std::find(only.begin(), only.end(), run.name) != only.end();
}

/** Runs that --only names and that are not there. */
void checkNames(const std::vector<Run>& runs, const RepairArguments& arguments) {
  for (const std::string& name : arguments.only)
    if (std::none_of(runs.begin(), runs.end(), [&](const Run& run) { return run.name == name; }))
      throw UsageError("repair: --only " + name +
                       ": no run has this name: name one of those that " +
                       "'roomgraph compare' prints");
}

/** What becomes of a run, for terminal and page. */
std::string lineOf(const RepairedRun& repaired, const char* unseen) {
  std::string line = repaired.reason;
  if (repaired.state == RepairState::mended)
    line += formatted(", moved by up to %.2f m at key frame %zu", repaired.movedMost,
                      repaired.movedMostAt);
  std::vector<std::string> stretches;
  for (const KeyFrames& stretch : repaired.unseen) stretches.push_back(stretch.text());
  if (!stretches.empty())
    line += "; key frames " + listed(stretches, 3) + " were " + unseen + " and stay on their links";
  return line;
}

/** The page of all runs, and its lines on the terminal. */
void tell(const std::vector<ShownRepair>& shown, const SiteArguments& site, StagedFiles& staged) {
  staged.add(inFolder(site.folder, kPage), repairPage(shown));
  staged.commit();
  std::string lines;
  for (const ShownRepair& one : shown) lines += printable(one.run->name + ": " + one.line) + "\n";
  if (!site.running.isQuiet) print(lines);
}

/** Mends one run by what it tells of itself. */
int runAlone(const RepairArguments& arguments) {
  const SiteArguments& site = arguments.site;
  CompareMapsOptions options = toCompareOptions(site.options);
  UnusedOptions unused;
  options.onNote = unused.listener();
  const Run run = readRun(site.files.front(), options);
  unused.tell();
  checkNames({run}, arguments);
  if (run.scans.empty()) throw DataError(run.file + ": has no scans: give a simplemap");
  const RunCheck check = checkRun(run);
  const RepairedRun repaired = repairAlone(run, check);
  StagedFiles staged;
  addRun(run, repaired, site.folder, staged);
  if (arguments.format == "mola") addConstraints(run, agreedPoses(check), site.folder, staged);
  tell({{&run, &repaired, lineOf(repaired, "driven once")}}, site, staged);
  if (repaired.state == RepairState::mended) writeGrids({run.file}, site);
  return kDone;
}

int run(const RepairArguments& arguments) {
  const SiteArguments& site = arguments.site;
  check(arguments);
  makeWritableFolder(site.folder);
  if (site.files.size() == 1 && site.reference.empty()) return runAlone(arguments);
  const auto runs = solveRuns(site);
  checkNames(runs->read.runs, arguments);
  StagedFiles staged;
  std::vector<ShownRepair> shown;
  std::vector<std::string> mended;
  const RealPoses real = rejoinPieces(runs->solved);
  const std::vector<RepairedRun> repaired = repairRuns(runs->solved, real);
  for (const RepairedRun& one : repaired) {
    const Run& run = runs->read.runs[one.run];
    if (!isAskedFor(run, arguments)) continue;
    addRun(run, one, site.folder, staged);
    if (one.state == RepairState::mended) mended.push_back(run.file);
    if (arguments.format == "mola") addConstraints(run, real[one.siteRun], site.folder, staged);
    shown.push_back({&run, &one, lineOf(one, "seen by no other run")});
  }
  if (shown.empty())
    throw DataError("repair: no run has scans and lies in the site of the others: give simplemaps");
  staged.add(inFolder(site.folder, kPoseGraph), withAuthor(graphG2o(runs->solved.consensus)));
  tell(shown, site, staged);
  writeGrids(mended, site);
  return runs->exitCode();
}

}  // namespace

std::function<int()> repairCommand(CLI::App& app) {
  const auto arguments = std::make_shared<RepairArguments>();
  addArgument(app, "RUN", arguments->site.files,
              "Simplemaps of one site, each of a drive. One alone is mended by what it saw twice.");
  declareSite(
      arguments->site,
      "repair.html, X.repaired.simplemap as X was compressed, X.repaired.tum, of mended runs "
      "X.repaired.gridmap.gz and X.repaired.yaml with .pgm, and of several runs "
      "site.g2o",
      app);
  addOption(app, "--format NAME", arguments->format,
            "Also write X.loop_constraints.yaml (format 'mola'), for the pipeline of MOLA's "
            "mola-sm-lc-cli: key frames of a run that were at the same place.");
  addOption(app, "--only NAME", arguments->only,
            "Write only the run of this name; all are used. May be repeated.")
      ->allow_extra_args(false);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
