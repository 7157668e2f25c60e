#include <array>
#include <memory>
#include <set>

#include "ResultFolder.h"
#include "commands.h"
#include "file_authors.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/compare/run_names.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/mrpt_plugin/mrpt_files.h"
#include "roomgraph/page/repair_page.h"
#include "roomgraph/repair/loop_constraints.h"
#include "roomgraph/repair/repair_runs.h"
#include "roomgraph/repair/repair_site.h"
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

constexpr std::array kGrids{".gridmap.gz", ".pgm", ".yaml"};

/** Of a run that was left as it was they are written only where an earlier call has written them:
 *  they would be those of another simplemap. */
bool needsGrids(const RepairedRun& repaired, const std::string& stem, const FolderFiles& files) {
  return repaired.state == RepairState::mended || anyOf(kGrids, [&](const char* extension) {
           return identityOf(inFolder(files.folder, stem + extension)).has_value();
         });
}

/** Says that other programs, which find key frames by their times, do not find them. */
void printSharedTimes(const Run& run) {
  const std::size_t own = countIf(haveOwnTimes(run.scans), [](bool has) { return has; });
  const std::size_t timed = countIf(run.scans, [](const ScanWalls& scan) { return !!scan.time; });
  if (own < timed)
    printError(run.file +
               formatted(": note: %zu of its %zu scans have the time of another key frame: no loop "
                         "constraints name them, and evo cannot tell them apart in the path",
                         timed - own, run.scans.size()));
}

void addRun(const Run& run, const RepairedRun& repaired, const ExtractOptions& options,
            FolderFiles& files) {
  printSharedTimes(run);
  const std::string stem = mapStem(run.file) + ".repaired";
  std::string simplemap;
  {
    const MovedRun moved = movedRun(run, repaired);
    simplemap = files.add(repairedName(run.file), moved.simplemap);
    files.add(stem + ".tum", moved.tum);
  }
  if (!needsGrids(repaired, stem, files)) return;
  const GreyMap map = loadGrid(simplemap, options.loadGrid);
  const Grid grid = binarize(map, options.binarize);
  files.add(stem + kGrids[0], gridmapBytes(map, grid));
  files.add(stem + kGrids[1], mapPgm(grid));
  files.add(stem + kGrids[2], rosMapYaml(grid.frame, stem + kGrids[1]));
}

/** The constraints for MOLA are of all runs, mended or not: they are for another back end. */
void addConstraints(const Run& run, const std::vector<Transform2D>& real, FolderFiles& files) {
  files.add(mapStem(run.file) + ".loop_constraints.yaml", withAuthor(molaConstraints(run, real)));
}

bool isAskedFor(const std::string& run, const RepairArguments& arguments) {
  return arguments.only.empty() || contains(arguments.only, run);
}

void check(const RepairArguments& arguments) {
  const SiteArguments& site = arguments.site;
  if (!arguments.format.empty() && arguments.format != "mola")
    throw UsageError("repair: there is no format '" + arguments.format + "': --format takes mola");
  std::vector<std::string> extensions{"repaired.tum"};
  for (const char* grid : kGrids) extensions.push_back(std::string("repaired") + grid);
  if (!arguments.format.empty()) extensions.emplace_back("loop_constraints.yaml");
  CallFiles files = filesReadBy(site.files, site.options);
  files.reads(site.reference);
  const std::vector<std::string> names = runNames(site.files);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!isAskedFor(names[i], arguments)) continue;
    std::set<std::string> results{inFolder(site.folder, repairedName(site.files[i]))};
    for (const std::string& extension : extensions)  // a grid is not mended, and may have its name
      results.insert(outputFile(site.folder, site.files[i], extension));
    for (const std::string& result : results) files.writes(result, site.files[i]);
  }
  for (const char* name : {kPage, kPoseGraph}) files.writes(inFolder(site.folder, name));
}

/** What becomes of a run, for terminal and page. */
std::string lineOf(const RepairedRun& repaired, const char* unseen) {
  std::string line = repaired.reason;
  if (repaired.state == RepairState::mended)
    line += formatted(", moved by up to %.2f m at key frame %zu", repaired.movedMost,
                      repaired.movedMostAt);
  const std::vector<std::string> stretches = mapped(repaired.unseen, &KeyFrames::text);
  if (repaired.isOneUnseen())
    line += "; key frame " + stretches[0] + " was " + unseen +
            " and keeps its pose relative to its neighbours";
  else if (!stretches.empty())
    line += "; key frames " + listed(stretches, 3) + " were " + unseen +
            " and keep their pose relative to their neighbours";
  return line;
}

/** The page of all runs and all files; then what became of them, on the terminal. */
void finish(const std::vector<ShownRepair>& shown, const SiteArguments& site, FolderFiles& files) {
  files.add(kPage, repairPage(shown));
  files.staged.commit();
  std::string lines;
  for (const ShownRepair& one : shown) lines += printable(one.run->name + ": " + one.line) + "\n";
  if (!site.running.isQuiet) print(lines + fileLines(files.names));
}

/** Names the maps without scans: they help, but are not mended. */
void printBare(const SolvedRuns& runs, const RepairArguments& arguments) {
  for (std::size_t i = 0; i < runs.read.runs.size(); ++i)
    if (const Run& run = runs.read.runs[i]; run.scans.empty() && isAskedFor(run.name, arguments) &&
                                            runs.read.reference != i && runs.solved.site.has(i))
      printError(run.file + ": has no scans, so it is not mended");
}

/** What the call ends with: a run that does not lie in the site of the others is not mended. */
int exitCodeOf(const SolvedRuns& runs, const RepairArguments& arguments) {
  for (std::size_t i = 0; i < runs.read.runs.size(); ++i)
    if (isAskedFor(runs.read.runs[i].name, arguments) && !runs.solved.site.has(i)) return kBadData;
  return runs.exitCode();
}

/** Mends one run by what it tells of itself. */
int runAlone(const RepairArguments& arguments) {
  const SiteArguments& site = arguments.site;
  CompareMapsOptions options = toCompareOptions(site.options);
  UnusedOptions unused;
  options.onNote = unused.takeOrWarn();
  const Run run = readRun(site.files.front(), options);
  unused.tell(1);
  if (run.scans.empty()) throw DataError(run.file + ": has no scans: give a simplemap");
  const RunCheck check = checkRun(run);
  const RepairedRun repaired = repairAlone(run, check);
  FolderFiles files{site.folder};
  addRun(run, repaired, options.extract, files);
  if (arguments.format == "mola") addConstraints(run, agreedPoses(check), files);
  finish({{&run, &repaired, lineOf(repaired, "driven once")}}, site, files);
  return kDone;
}

int run(RepairArguments arguments) {
  const SiteArguments& site = arguments.site;
  for (std::string& only : arguments.only) only = nameOfRun(only, runNames(site.files), "--only");
  check(arguments);
  const ResultFolder folder(site.folder);
  if (site.files.size() == 1 && site.reference.empty()) return runAlone(arguments);
  const auto runs = solvedRunsOf(site);
  if (runs->solved.site.runs.size() < 2)
    throw DataError("repair: no two runs lie in one site: name one alone to mend it by itself");
  printBare(*runs, arguments);
  FolderFiles files{site.folder};
  const ExtractOptions options = toCompareOptions(site.options).extract;
  std::vector<ShownRepair> shown;
  const RealPoses real = rejoinPieces(runs->solved);
  const std::vector<RepairedRun> repaired = repairRuns(runs->solved, real);
  for (const RepairedRun& one : repaired) {
    const Run& run = runs->read.runs[one.run];
    if (!isAskedFor(run.name, arguments)) continue;
    addRun(run, one, options, files);
    if (arguments.format == "mola") addConstraints(run, real[one.siteRun], files);
    shown.push_back({&run, &one, lineOf(one, "confirmed by no other run")});
  }
  if (shown.empty())
    throw DataError("repair: no run has scans and lies in the site of the others: give simplemaps");
  files.add(kPoseGraph, withAuthor(graphG2o(runs->solved.consensus)));
  finish(shown, site, files);
  return exitCodeOf(*runs, arguments);
}

}  // namespace

std::function<int()> repairCommand(CLI::App& app) {
  const auto arguments = std::make_shared<RepairArguments>();
  addArgument(app, "RUN", arguments->site.files,
              "Simplemaps of one site, each of a drive. One alone is mended by what it saw twice. "
              "The exit code is 1 if one could not be read, or does not lie in the site of the "
              "others.");
  declareSite(
      arguments->site,
      "repair.html, X.repaired.simplemap (compressed like X) and X.repaired.tum; for mended runs "
      "also X.repaired.gridmap.gz and X.repaired.yaml with .pgm; for several runs also site.g2o",
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
