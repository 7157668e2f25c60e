#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "Laps.h"
#include "ResultFolder.h"
#include "commands.h"
#include "comparison_results.h"
#include "more_files.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/compare/run_names.h"
#include "roomgraph/ledger/name_rooms.h"
#include "roomgraph/report/PairFolder.h"
#include "roomgraph/report/site_json.h"
#include "site_runs.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct CompareArguments : SiteArguments {
  bool areAligned = false, estimatesScale = false;
  GateArguments gate;
  std::vector<std::string> candidates;  ///< files that the gate judges; empty for all
  std::string formats = "all";
  std::string names;  ///< file of the site's rooms; empty for none
  bool writesBreaks = false, writesSiteMaps = false;
  bool comparesEachSite = false;
};

void declareFrames(CompareArguments& arguments, CLI::App& app) {
  CLI::Option* aligned =
      app.add_flag("--aligned", arguments.areAligned,
                   "The maps share one frame already: do not look for their poses.");
  app.add_flag("--estimate-scale", arguments.estimatesScale,
               "Find the scale at which bare pictures, such as floor plans, fit the other maps; "
               "--resolution is then only a first guess.")
      ->excludes(aligned);
  addOption(app, "--reference MAP", arguments.reference,
            "Measure all runs against this map instead of against each other.");
}

void declareResults(CompareArguments& arguments, CLI::App& app) {
  declareOutput(arguments.folder, listedFiles(), app);
  declareFormats(arguments.formats, app);
  addOption(app, "--names FILE", arguments.names,
            "JSON file that keeps the ids and names of the site's rooms from call to call. It is "
            "created if missing, and updated unless the gate fails. Names in it may be edited.");
  addOption(
      app, "--cache DIR", arguments.cache,
      "Folder that keeps what was found for each pair of maps, so that a further run costs only "
      "its own pairs; created if missing. It changes no result, and its files may be deleted.");
  app.add_flag("--break-files", arguments.writesBreaks,
               "Also write the scans around each break N of a run with scans, for RawLogViewer and "
               "SceneViewer3D: comparison.breakN.rawlog, .untorn.rawlog and .3Dscene.");
  app.add_flag("--site-maps", arguments.writesSiteMaps,
               "Also write each map as a ROS map in the frame of the site (comparison.RUN.yaml and "
               ".pgm), its pose there (.pose.yaml), and comparison.maps.toml, a session for the "
               "viewer 'maps' with all of them.");
  app.add_flag("--each-site", arguments.comparesEachSite,
               "If the maps show several sites, such as two floors, compare each site by itself: "
               "the one with the most runs goes into --output, the next into its folder site2, and "
               "so on. Not with a gate, --names or --reference.");
}

void declareJudged(CompareArguments& arguments, CLI::App& app) {
  addOption(app, "--candidate MAP", arguments.candidates,
            "One more map, and the only one that the gate judges; the others are the record "
            "that it is compared with. May be repeated.")
      ->allow_extra_args(false);
  declareGate(arguments.gate, app);
}

bool isReference(const std::string& file, const CompareArguments& arguments) {
  std::error_code error;
  return std::filesystem::equivalent(file, arguments.reference, error);
}

/** The record and the candidates, each file once; against itself the reference is perfect. */
std::vector<std::string> allFiles(const CompareArguments& arguments) {
  std::vector<std::string> files;
  for (const std::string& file : arguments.files)
    if (!isReference(file, arguments)) files.push_back(file);
  for (const std::string& file : arguments.candidates)
    if (!contains(files, file)) files.push_back(file);
  return files;
}

/** The same with the reference. */
std::vector<std::string> allMaps(const CompareArguments& arguments) {
  std::vector<std::string> maps = allFiles(arguments);
  if (!arguments.reference.empty()) maps.push_back(arguments.reference);
  return maps;
}

/** The folder of a site: that of the call for the first, in it "site2" for the second. */
std::string folderOf(std::size_t site, const CompareArguments& arguments) {
  if (site < 2) return arguments.folder;
  return inFolder(arguments.folder, "site" + std::to_string(site));
}

/** Throws where a result would take the place of what is not to be replaced. */
void checkFiles(const CompareArguments& arguments) {
  const std::vector<std::string> maps = allMaps(arguments);
  CallFiles files = filesReadBy(maps, arguments.options);
  files.updates("--names", arguments.names);
  files.writesTo("--junit", arguments.gate.junit);
  files.writesTo("--summary", arguments.gate.summary);
  const std::size_t sites = arguments.comparesEachSite ? maps.size() / 2 : 1;
  for (std::size_t site = 1; site <= sites; ++site) {
    const std::string folder = folderOf(site, arguments);
    const ResultFiles results(folder, arguments.formats);
    for (const std::string& result : results.names()) files.writes(result);
    const auto addNames = [&](const std::vector<std::string>& names) {
      for (const std::string& name : names) files.writes(inFolder(folder, name));
    };
    if (results.hasTrajectories()) addNames(trajectoryNames(runNames(maps)));
    if (arguments.writesSiteMaps) addNames(siteMapNames(runNames(maps)));
    if (arguments.writesBreaks) files.writesNumbered(inFolder(folder, "comparison.break"));
  }
}

std::vector<std::string> candidatesOf(const CompareArguments& arguments,
                                      const Comparison& comparison) {
  std::vector<std::string> names;
  const auto add = [&](const auto& run) {
    if (contains(arguments.candidates, run.file)) names.push_back(run.name);
  };
  for (const ComparedRun& run : comparison.runs) add(run);
  for (const LeftOutRun& run : comparison.leftOut) add(run);
  return names;
}

CompareMapsOptions optionsOf(const CompareArguments& arguments) {
  CompareMapsOptions options = siteOptions(arguments);
  options.compare.areAligned |= arguments.areAligned;
  options.estimatesScale |= arguments.estimatesScale;
  return options;
}

/** Reads the maps, and tells what is odd about them. */
ReadRuns readMaps(const CompareArguments& arguments) {
  CompareMapsOptions options = optionsOf(arguments);
  std::vector<MapNote> notes;
  UnusedOptions unused;
  options.onNote = [&](const std::string& file, Note note) {
    if (unused.take(note)) return;
    if (note.code == "assumed_resolution") note.text += "; --estimate-scale finds it";
    notes.push_back({file, std::move(note)});
  };
  ReadRuns read = readRuns(allFiles(arguments), options);
  unused.tell(allMaps(arguments).size());
  std::fputs(noteLines(notes, arguments.running).c_str(), stderr);
  return read;
}

/** Compares, with what is kept of earlier calls. */
Comparison compare(const ReadRuns& read, const CompareArguments& arguments) {
  CompareMapsOptions options = optionsOf(arguments);
  PairFolder cache(arguments.cache);
  options.compare.kept = cache.kept();
  Comparison comparison = compareMaps(read, options);
  if (!cache.failure().empty()) printError(cache.failure());
  return comparison;
}

/** Whether a call asks for what only one site has. */
bool isOfOneSite(const CompareArguments& arguments) {
  return !arguments.gate.limits.asksNothing() || !arguments.names.empty() ||
         !arguments.candidates.empty() || !arguments.reference.empty();
}

void check(const CompareArguments& arguments) {
  for (const std::string& candidate : arguments.candidates)
    if (isReference(candidate, arguments))
      throw UsageError("compare: " + candidate +
                       " cannot be judged by itself: it is the reference");
  if (allFiles(arguments).empty() || allMaps(arguments).size() < 2)
    throw UsageError(
        "compare: one run cannot be compared: name two; 'roomgraph check' judges a single run");
  if (arguments.comparesEachSite && isOfOneSite(arguments))
    throw UsageError(
        "compare: --each-site cannot be combined with --names, --reference, --candidate or a gate: "
        "run 'roomgraph report' on the comparison.json of each site instead");
}

/** What could be read, but is of another site than those that were compared. */
ReadRuns otherSitesIn(ReadRuns read, const Comparison& comparison) {
  const std::vector<std::string> names = mapped(comparison.leftOut, &LeftOutRun::name);
  ReadRuns others;
  for (Run& run : read.runs)
    if (contains(names, run.name)) others.runs.push_back(std::move(run));
  return others;
}

void writeResults(Comparison comparison, const std::vector<Run>& runs,
                  const CompareArguments& arguments, FolderFiles& more) {
  const ResultFiles files(more.folder, arguments.formats);
  for (ComparedRun& run : comparison.runs) run.relativePath = seenFrom(more.folder, run.file);
  const ExtractOptions options = toCompareOptions(arguments.options).extract;
  if (arguments.writesBreaks) addBreakFiles(comparison, runs, options.loadGrid, more);
  if (arguments.writesSiteMaps) addSiteMaps(comparison, options, more);
  if (files.hasTrajectories()) addTrajectories(comparison, more);
  addResults(comparison, runs, files, more.names, more.staged);
  more.staged.commit();
  if (!arguments.running.isQuiet) printResults(comparison, files, more.names);
}

/** Compares the sites beside the first, the one with most runs before the others. */
void compareOtherSites(ReadRuns read, Comparison comparison, const CompareArguments& arguments) {
  for (std::size_t number = 2;; ++number) {
    read = otherSitesIn(std::move(read), comparison);
    if (read.runs.size() < 2) return;
    comparison = compare(read, arguments);
    if (comparison.runs.size() < 2) return;
    FolderFiles files{folderOf(number, arguments)};
    makeWritableFolder(files.folder);
    writeResults(comparison, read.runs, arguments, files);
  }
}

/** Names maps of other sites, unless these are compared. Whether one could not be read at all. */
bool printLeftOut(const Comparison& comparison, const CompareArguments& arguments) {
  const char* const hint =
      arguments.areAligned ? "; if it has a frame of its own, leave --aligned out" : "";
  bool isUnread = false, areMoreSites = false;
  for (const LeftOutRun& left : comparison.leftOut) {
    isUnread |= !left.isOtherSite, areMoreSites |= left.hasMates;
    const bool isCompared = arguments.comparesEachSite && left.hasMates;
    if (left.isOtherSite && !isCompared) printError(left.file + ": " + left.reason + hint);
  }
  if (areMoreSites && !arguments.comparesEachSite && !isOfOneSite(arguments))
    printError("compare: --each-site compares each site by itself");
  return isUnread;
}

int run(const CompareArguments& arguments) {
  check(arguments);
  GateOptions gate = arguments.gate.limits;
  checkFiles(arguments);
  const ResultFolder folder(arguments.folder);
  std::optional<SiteFile> site;
  if (!arguments.names.empty()) site = readSite(arguments.names);
  Laps laps;
  ReadRuns read = readMaps(arguments);
  laps.end("read_maps");
  if (arguments.running.isVerbose) printMaps(read.runs);
  Comparison comparison = compare(read, arguments);
  laps.end("compare");
  if (site) {
    NamedRooms named = nameRooms(std::move(comparison.rooms), *std::move(site), arguments.names);
    comparison.rooms = std::move(named.rooms), site = std::move(named.file);
  }
  FolderFiles files{arguments.folder};
  gate.candidates = candidatesOf(arguments, comparison);
  const bool gateFails = addGate(comparison, gate);
  // The rooms of a bad run are not to be remembered.
  if (site && !gateFails) files.staged.add(arguments.names, siteJson(*site));
  addGateFiles(comparison, arguments.gate, files.staged);
  const bool isUnread = printLeftOut(comparison, arguments);
  writeResults(comparison, read.runs, arguments, files);
  if (arguments.comparesEachSite) compareOtherSites(std::move(read), comparison, arguments);
  laps.end("write_files");
  if (arguments.running.showsTimings) std::fputs(laps.table("compare").c_str(), stderr);
  const int exitCode = exitCodeOf(comparison, gate);
  if (site && gateFails) printError(arguments.names + ": left as it was, as the gate fails");
  return exitCode == kDone && isUnread ? kBadData : exitCode;
}

}  // namespace

std::function<int()> compareCommand(CLI::App& app) {
  const auto arguments = std::make_shared<CompareArguments>();
  addArgument(app, "RUN", arguments->files,
              "Maps of one site, as for 'roomgraph extract'; each may have a frame of its own.");
  underHeading("Maps", app, [&] {
    declareFrames(*arguments, app);
    declareReading(arguments->options, app);
    declareRooms(arguments->options, app);
    declareConfig(arguments->options, app);
  });
  underHeading("Output", app, [&] { declareResults(*arguments, app); });
  underHeading("Gate", app, [&] { declareJudged(*arguments, app); });
  declareRunning(arguments->running, "maps or pairs", "what each map holds", app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
