#include "compare_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "Command.h"
#include "compare_maps.h"
#include "error_line.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/mrpt_plugin/comparison_scene.h"
#include "roomgraph/report/StagedFiles.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/comparison_report.h"
#include "roomgraph/report/site_json.h"
#include "terminal.h"

namespace roomgraph {
namespace {

constexpr double kMinCoverage = 0.7;

struct CompareArguments {
  CompareTask task;
  OptionArguments options;
  std::string folder = ".";
  std::optional<double> failBelow;
  std::vector<std::string> failOn;
};

void declareGate(CompareArguments& arguments, CLI::App& app) {
  app.add_option("--fail-below", arguments.failBelow,
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
      app.add_flag("--aligned", arguments.task.isAligned,
                   "All maps are in one frame already [m]: do not look for their poses.");
  app.add_flag("--estimate-scale", arguments.task.estimatesScale,
               "Read bare pictures, such as floor plans, at the scale at which they fit the other "
               "maps, which must have one; --resolution is only the first guess.")
      ->excludes(aligned);
  app.add_option("--reference", arguments.task.reference,
                 "A map to measure all runs against, instead of against each other.")
      ->type_name("MAP");
  app.add_option(
         "--names", arguments.task.names,
         "JSON file that keeps the ids and names of the site's rooms from call to call; made "
         "if it is not there, else brought up to date, but not where --fail-below or --fail-on "
         "strikes. Names in it may be edited.")
      ->type_name("FILE");
  app.add_option("--cache", arguments.task.cache,
                 "Folder that keeps what is found of each pair of maps from call to call, made if "
                 "it is not there: one more run then costs its own pairs only. Changes no result; "
                 "its files may be deleted.")
      ->type_name("DIR");
  app.add_option("--threads", arguments.task.threads,
                 "How many maps or pairs are worked on at the same time; 0 for one per core.")
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("-q,--quiet", arguments.task.isQuiet, "Print nothing but errors.");
}

std::string whereBroken(const MapBreak& found) {
  char text[100];
  std::snprintf(text, sizeof text, "at (%.1f, %.1f) by %.1f degrees and %.2f m", found.place.x,
                found.place.y, found.rotation * 180 / M_PI, found.shift);
  return text;
}

/** What --fail-below and --fail-on have to say, a line each; empty where nothing strikes. */
std::string complaints(const Comparison& comparison, const CompareArguments& arguments) {
  std::string lines;
  const auto isAsked = [&](const char* what) {
    return std::count(arguments.failOn.begin(), arguments.failOn.end(), what) > 0;
  };
  for (const ComparedRun& run : comparison.runs) {
    if (run.name == comparison.reference) continue;
    if (arguments.failBelow && !run.score)
      lines += errorLine(run.name + ": has no score");
    else if (arguments.failBelow && run.score->score < *arguments.failBelow)
      lines += errorLine(run.name + ": its score is below --fail-below");
    for (const Measure& measure : run.measures)
      if (isAsked("coverage") && measure.name == "coverage" &&
          measure.value.value_or(0) < kMinCoverage)
        lines += errorLine(run.name + ": has seen less than 70 % of what two runs have seen");
  }
  for (const MapBreak& found : comparison.breaks)
    if (isAsked("broken")) lines += errorLine(found.run + ": is broken " + whereBroken(found));
  for (const LeftOutRun& run : comparison.leftOut) {
    if (arguments.failBelow) lines += errorLine(run.name + ": has no score");
    if (run.isOtherSite && isAsked("not-same-site"))
      lines += errorLine(run.name + ": is not of the same site");
  }
  return lines;
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

void checkNotReplaced(const CompareTask& task, const ResultFiles& files) {
  std::vector<std::string> inputs = task.files, results = files.all();
  for (const std::string& result : results)
    if (!task.names.empty() && wouldBeSameFile(task.names, result))
      throw UsageError(task.names + ": would be replaced by a result: choose another file with " +
                       "--names");
  results.push_back(task.names);
  inputs.push_back(task.reference);
  for (const std::string& result : results)
    for (const std::string& input : inputs)
      if (areSameFile(result, input))
        throw UsageError(result + ": would replace a map: choose another folder with --output");
}

/** What report.html says of the options, in the order of the work. */
std::vector<UsedOption> optionsOf(const CompareTask& task) {
  ExtractOptions extract = task.extract;
  std::vector<UsedOption> options = usedOptions(describe(extract));
  options.push_back({"compare", "aligned", task.isAligned ? "true" : "false", "",
                     "All maps are in one frame already."});
  options.push_back({"compare", "estimate_scale", task.estimatesScale ? "true" : "false", "",
                     "Bare pictures are read at the scale at which they fit the other maps."});
  options.push_back({"compare", "reference",
                     std::filesystem::path(task.reference).filename().string(), "",
                     "The map that all runs are measured against; empty for none."});
  return options;
}

/** All of them, or none where one cannot be written. */
void writeResults(const ComparedMaps& maps, const CompareTask& task, const ResultFiles& files,
                  bool keepsNames) {
  const Comparison& comparison = maps.comparison;
  StagedFiles staged;
  if (maps.site && keepsNames) staged.add(task.names, siteJson(*maps.site));
  staged.add(files.json, comparisonJson(comparison));
  staged.add(files.runs, comparisonRunsCsv(comparison));
  staged.add(files.rooms, comparisonRoomsCsv(comparison));
  staged.add(files.scene, comparisonSceneBytes(comparison, maps.runs));
  staged.add(files.report, comparisonReport(comparison, maps.runs, optionsOf(task)));
  staged.commit();
}

int run(const CompareArguments& arguments) {
  if (arguments.failBelow && std::isnan(*arguments.failBelow))
    throw UsageError("--fail-below: nan is no score: give one from 0 to 100");
  CompareTask task = arguments.task;
  task.extract = toOptions(arguments.options);
  if (task.files.size() + (task.reference.empty() ? 0 : 1) < 2)
    throw UsageError("compare: one run cannot be compared: name two, or a --reference");
  const ResultFiles files(arguments.folder);
  checkNotReplaced(task, files);
  makeWritableFolder(arguments.folder);
  const ComparedMaps result = compareMaps(task);
  const Comparison& comparison = result.comparison;
  // The rooms of a bad run are not to be remembered.
  const std::string struck = complaints(comparison, arguments);
  writeResults(result, task, files, struck.empty());
  for (const LeftOutRun& run : comparison.leftOut)
    if (run.isOtherSite) std::fputs(errorLine(run.file + ": " + run.reason).c_str(), stderr);
  if (!task.isQuiet) {
    std::string text = comparisonText(comparison) + comparison.verdict + "\n";
    for (const std::string& file : files.all()) text += "  " + printable(file) + "\n";
    print(text);
  }
  if (struck.empty()) return result.exitCode;
  std::fputs(struck.c_str(), stderr);
  if (result.site)
    std::fputs(errorLine(task.names + ": left as it was, as the gate strikes").c_str(), stderr);
  return kStruck;
}

}  // namespace

std::function<int()> compareCommand(CLI::App& app) {
  const auto arguments = std::make_shared<CompareArguments>();
  app.add_option("RUN", arguments->task.files,
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
