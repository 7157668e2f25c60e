#include "compare_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "Command.h"
#include "compare_maps.h"
#include "error_line.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/compare/comparison_json.h"
#include "roomgraph/mrpt_plugin/comparison_scene.h"
#include "roomgraph/report/comparison_report.h"
#include "roomgraph/report/write_file.h"

namespace roomgraph {
namespace {

constexpr double kMinCoverage = 0.7;

struct CompareArguments {
  CompareTask task;
  OptionArguments options;
  std::string folder = ".";
  double failBelow = 0;
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
         "if it is not there, else brought up to date. Names in it may be edited.")
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
    if (arguments.failBelow > 0 && (!run.score || run.score->score < arguments.failBelow))
      lines += errorLine(run.name + ": its score is below --fail-below");
    for (const Measure& measure : run.measures)
      if (isAsked("coverage") && measure.name == "coverage" &&
          measure.value.value_or(0) < kMinCoverage)
        lines += errorLine(run.name + ": has seen less than 70 % of what two runs have seen");
  }
  for (const MapBreak& found : comparison.breaks)
    if (isAsked("broken")) lines += errorLine(found.run + ": is broken " + whereBroken(found));
  for (const LeftOutRun& run : comparison.leftOut) {
    if (arguments.failBelow > 0) lines += errorLine(run.name + ": has no score");
    if (run.isOtherSite && isAsked("not-same-site"))
      lines += errorLine(run.name + ": is not of the same site");
  }
  return lines;
}

void checkNotReplaced(const CompareTask& task, const std::vector<std::string>& results) {
  std::vector<std::string> inputs = task.files;
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

int run(const CompareArguments& arguments) {
  CompareTask task = arguments.task;
  task.extract = toOptions(arguments.options);
  if (task.files.size() + (task.reference.empty() ? 0 : 1) < 2)
    throw UsageError("compare: one run cannot be compared: name two, or a --reference");
  const std::filesystem::path folder = arguments.folder;
  const std::string json = (folder / "comparison.json").string();
  const std::string csv = (folder / "comparison.runs.csv").string();
  const std::string rooms = (folder / "comparison.rooms.csv").string();
  const std::string report = (folder / "report.html").string();
  const std::string scene = (folder / "comparison.3Dscene").string();
  checkNotReplaced(task, {json, csv, rooms, report, scene, task.names});
  makeWritableFolder(arguments.folder);
  const ComparedMaps result = compareMaps(task);
  const Comparison& comparison = result.comparison;
  if (result.site) writeFileAtomically(task.names, siteJson(*result.site));
  writeFileAtomically(json, comparisonJson(comparison));
  writeFileAtomically(csv, comparisonRunsCsv(comparison));
  writeFileAtomically(rooms, comparisonRoomsCsv(comparison));
  writeFileAtomically(scene, comparisonSceneBytes(comparison, result.runs));
  writeFileAtomically(report, comparisonReport(comparison, result.runs, optionsOf(task)));
  for (const LeftOutRun& run : comparison.leftOut)
    if (run.isOtherSite) std::fputs(errorLine(run.file + ": " + run.reason).c_str(), stderr);
  if (!task.isQuiet)
    std::printf("%s%s\n  %s\n  %s\n  %s\n  %s\n  %s\n", comparisonText(comparison).c_str(),
                comparison.verdict.c_str(), report.c_str(), json.c_str(), csv.c_str(),
                rooms.c_str(), scene.c_str());
  const std::string struck = complaints(comparison, arguments);
  std::fputs(struck.c_str(), stderr);
  return struck.empty() ? result.exitCode : int(kStruck);
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
