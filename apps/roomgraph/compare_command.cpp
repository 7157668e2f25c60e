#include "compare_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "Command.h"
#include "error_line.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/compare/gate.h"
#include "roomgraph/ledger/name_rooms.h"
#include "roomgraph/mrpt_plugin/comparison_scene.h"
#include "roomgraph/report/PairFolder.h"
#include "roomgraph/report/StagedFiles.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/comparison_report.h"
#include "roomgraph/report/site_json.h"
#include "roomgraph/report/write_file.h"
#include "run_in_order.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct CompareArguments {
  CompareMapsOptions compare;
  GateOptions gate;
  OptionArguments options;
  std::vector<std::string> files, failOn;
  std::string folder = ".";
  std::string names;     ///< file of the site's rooms; empty for none
  std::string cache;     ///< folder that keeps pairs from call to call; empty for none
  unsigned threads = 0;  ///< 0 for one per core
  bool isQuiet = false;
};

void declareGate(CompareArguments& arguments, CLI::App& app) {
  app.add_option("--fail-below", arguments.gate.minScore,
                 "Exit with 3 where a run has a score below this (0 to 100), or none.")
      ->type_name("SCORE")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option(
         "--fail-on", arguments.failOn,
         "Exit with 3 on any of these, separated by commas: 'coverage' (a run has seen less "
         "than 70 % of what two runs have seen), 'broken' (a run has a break), "
         "'not-same-site' (a run is of another site).")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"coverage", "broken", "not-same-site"}));
}

void declareRunning(CompareArguments& arguments, CLI::App& app) {
  app.add_option("-o,--output", arguments.folder,
                 "Folder for the results: report.html, comparison.json, comparison.runs.csv, "
                 "comparison.rooms.csv and comparison.3Dscene; made if it is not there.")
      ->type_name("DIR")
      ->capture_default_str();
  CLI::Option* aligned =
      app.add_flag("--aligned", arguments.compare.compare.areAligned,
                   "All maps are in one frame already [m]: do not look for their poses.");
  app.add_flag("--estimate-scale", arguments.compare.estimatesScale,
               "Read bare pictures, such as floor plans, at the scale at which they fit the other "
               "maps, which must have one; --resolution is only the first guess.")
      ->excludes(aligned);
  app.add_option("--reference", arguments.compare.reference,
                 "A map to measure all runs against, instead of against each other.")
      ->type_name("MAP");
  app.add_option(
         "--names", arguments.names,
         "JSON file that keeps the ids and names of the site's rooms from call to call; made "
         "if it is not there, else brought up to date, but not where --fail-below or --fail-on "
         "strikes. Names in it may be edited.")
      ->type_name("FILE");
  app.add_option("--cache", arguments.cache,
                 "Folder that keeps what is found of each pair of maps from call to call, made if "
                 "it is not there: one more run then costs its own pairs only. Changes no result; "
                 "its files may be deleted.")
      ->type_name("DIR");
  app.add_option("--threads", arguments.threads,
                 "How many maps or pairs are worked on at the same time; 0 for one per core.")
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("-q,--quiet", arguments.isQuiet, "Print nothing but errors.");
}

/** The names of all that is written to the folder. */
struct ResultFiles {
  explicit ResultFiles(const std::filesystem::path& folder)
      : report((folder / "report.html").string()),
        json((folder / "comparison.json").string()),
        runs((folder / "comparison.runs.csv").string()),
        rooms((folder / "comparison.rooms.csv").string()),
        scene((folder / "comparison.3Dscene").string()) {}

  std::vector<std::string> all() const { return {report, json, runs, rooms, scene}; }

  std::string report, json, runs, rooms, scene;
};

void checkNotReplaced(const CompareArguments& arguments, const ResultFiles& files) {
  std::vector<std::string> inputs = arguments.files, results = files.all();
  for (const std::string& result : results)
    if (!arguments.names.empty() && wouldBeSameFile(arguments.names, result))
      throw UsageError(arguments.names + ": would be replaced by a result: choose another file " +
                       "with --names");
  results.push_back(arguments.names);
  inputs.push_back(arguments.compare.reference);
  for (const std::string& result : results)
    for (const std::string& input : inputs)
      if (areSameFile(result, input))
        throw UsageError(result + ": would replace a map: choose another folder with --output");
}

/** What report.html says of the options, in the order of the work. */
std::vector<UsedOption> optionsOf(const CompareMapsOptions& used) {
  ExtractOptions extract = used.extract;
  std::vector<UsedOption> options = usedOptions(describe(extract));
  options.push_back({"compare", "aligned", used.compare.areAligned ? "true" : "false", "",
                     "All maps are in one frame already."});
  options.push_back({"compare", "estimate_scale", used.estimatesScale ? "true" : "false", "",
                     "Bare pictures are read at the scale at which they fit the other maps."});
  options.push_back({"compare", "reference",
                     std::filesystem::path(used.reference).filename().string(), "",
                     "The map that all runs are measured against; empty for none."});
  return options;
}

/** The rooms of the site as they are known; nothing where there is no such file. */
SiteFile readSite(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  return parseSiteJson(readFile(file), file);
}

/** All of them, or none where one cannot be written. */
void writeResults(const Comparison& comparison, const std::vector<Run>& runs,
                  const std::vector<UsedOption>& options, const ResultFiles& files,
                  StagedFiles& staged) {
  staged.add(files.json, comparisonJson(comparison));
  staged.add(files.runs, comparisonRunsCsv(comparison));
  staged.add(files.rooms, comparisonRoomsCsv(comparison));
  staged.add(files.scene, comparisonSceneBytes(comparison, runs));
  staged.add(files.report, comparisonReport(comparison, runs, options));
  staged.commit();
}

/** Jobs on the threads that were asked for, with a bar of their progress. */
ForEach onThreads(const CompareArguments& arguments) {
  return [&arguments](std::size_t count, const std::function<void(std::size_t)>& job) {
    JobList jobs;
    jobs.count = count;
    jobs.run = [&](std::size_t i, const std::function<void()>& stepDone) {
      job(i);
      stepDone();
      return JobReport();
    };
    runInOrder(jobs, arguments.threads, !arguments.isQuiet);
  };
}

void printError(const std::string& text) { std::fputs(errorLine(text).c_str(), stderr); }

void printResults(const Comparison& comparison, const ResultFiles& files) {
  std::string text = comparisonText(comparison) + comparison.verdict + "\n";
  for (const std::string& file : files.all()) text += "  " + printable(file) + "\n";
  print(text);
}

/** Reads and compares; a file that cannot be used is a line on stderr. */
std::pair<ReadRuns, Comparison> compared(const CompareArguments& arguments) {
  CompareMapsOptions options = arguments.compare;
  options.extract = toOptions(arguments.options);
  options.compare.forEach = onThreads(arguments);
  options.onUnread = [](const LeftOutRun& run) { printError(run.file + ": " + run.reason); };
  ReadRuns read = readRuns(arguments.files, options);
  std::optional<PairFolder> cache;
  if (!arguments.cache.empty()) options.compare.kept = cache.emplace(arguments.cache).kept();
  Comparison comparison = compareMaps(read, options);
  if (cache && !cache->failure().empty()) printError(cache->failure());
  return {std::move(read), std::move(comparison)};
}

void check(const CompareArguments& arguments) {
  if (arguments.gate.minScore && std::isnan(*arguments.gate.minScore))
    throw UsageError("--fail-below: nan is no score: give one from 0 to 100");
  if (arguments.files.size() + (arguments.compare.reference.empty() ? 0 : 1) < 2)
    throw UsageError("compare: one run cannot be compared: name two, or a --reference");
}

GateOptions gateOf(const CompareArguments& arguments) {
  const auto isAsked = [&](const char* what) {
    return std::count(arguments.failOn.begin(), arguments.failOn.end(), what) > 0;
  };
  return {arguments.gate.minScore, isAsked("coverage"), isAsked("broken"),
          isAsked("not-same-site")};
}

int run(const CompareArguments& arguments) {
  check(arguments);
  const ResultFiles files(arguments.folder);
  checkNotReplaced(arguments, files);
  makeWritableFolder(arguments.folder);
  std::optional<SiteFile> site;
  if (!arguments.names.empty()) site = readSite(arguments.names);
  auto [read, comparison] = compared(arguments);
  if (site) nameRooms(comparison.rooms, *site, arguments.names);
  const std::vector<std::string> struck = complaints(comparison, gateOf(arguments));
  StagedFiles staged;
  // The rooms of a bad run are not to be remembered.
  if (site && struck.empty()) staged.add(arguments.names, siteJson(*site));
  CompareMapsOptions used = arguments.compare;
  used.extract = toOptions(arguments.options);
  writeResults(comparison, read.runs, optionsOf(used), files, staged);
  bool isUnread = false;
  for (const LeftOutRun& left : comparison.leftOut)
    left.isOtherSite ? printError(left.file + ": " + left.reason) : void(isUnread = true);
  if (!arguments.isQuiet) printResults(comparison, files);
  for (const std::string& line : struck) printError(line);
  if (site && !struck.empty())
    printError(arguments.names + ": left as it was, as the gate strikes");
  return !struck.empty() ? kStruck : isUnread ? kBadData : kDone;
}

}  // namespace

std::function<int()> compareCommand(CLI::App& app) {
  const auto arguments = std::make_shared<CompareArguments>();
  app.add_option("RUN", arguments->files,
                 "Maps of one site, as for 'roomgraph extract'; their frames may differ.")
      ->type_name("")
      ->required();
  declareRunning(*arguments, app);
  declareGate(*arguments, app);
  declareConfig(arguments->options, app);
  declareResolution(arguments->options, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
