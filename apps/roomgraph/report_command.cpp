#include <map>
#include <memory>
#include <utility>

#include "CallFiles.h"
#include "commands.h"
#include "comparison_results.h"
#include "option_arguments.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/compare/run_names.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/comparison_sentences.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct ReportArguments {
  std::string comparison;
  std::vector<std::string> maps, candidates;
  GateArguments gate;
  std::string folder;
  bool isQuiet = false;
};

/** The folder that was asked for, or that of the comparison. */
std::filesystem::path folderOf(const ReportArguments& arguments) {
  if (!arguments.folder.empty()) return arguments.folder;
  const auto folder = std::filesystem::path(arguments.comparison).parent_path();
  return folder.empty() ? "." : folder;
}

/** A name that is none of them would be judged by nothing. */
std::vector<std::string> candidatesOf(const ReportArguments& arguments,
                                      const Comparison& comparison) {
  std::vector<std::string> names, candidates;
  for (const ComparedRun& run : comparison.runs) names.push_back(run.name);
  for (const LeftOutRun& run : comparison.leftOut) names.push_back(run.name);
  for (const std::string& given : arguments.candidates)
    candidates.push_back(nameOfRun(given, names, "--candidate"));
  return candidates;
}

struct FoundMaps {
  std::vector<Run> runs;
  std::map<std::string, std::filesystem::path> places;  ///< by the name of the run

  void look(const std::string& file, const Comparison& comparison) {
    for (Run& run : readMapsOf(comparison, {file}))
      if (places.emplace(run.name, file).second) runs.push_back(std::move(run));
  }
};

/** Those that were named, or else those near the comparison. */
FoundMaps findMaps(const ReportArguments& arguments, const Comparison& comparison) {
  FoundMaps maps;
  for (const std::string& file : arguments.maps) maps.look(file, comparison);
  if (!arguments.maps.empty()) return maps;
  for (const ComparedRun& run : comparison.runs)
    for (const std::string& file : mapsNear(run, arguments.comparison))
      if (maps.places.count(run.name) == 0) maps.look(file, comparison);
  return maps;
}

/** Throws where a result would take the place of what is not to be replaced. */
void checkFiles(const ReportArguments& arguments, const Comparison& comparison,
                const ResultFiles& results) {
  CallFiles files;
  files.reads(arguments.maps);
  for (const ComparedRun& run : comparison.runs) files.reads(mapsNear(run, arguments.comparison));
  files.consults(arguments.comparison);
  for (const std::string& result : results.names()) files.writes(result);
  files.writesTo("--junit", arguments.gate.junit);
  files.writesTo("--summary", arguments.gate.summary);
}

/** Where the maps are, as seen from the folder of the results. */
void tellPlaces(Comparison& comparison, const FoundMaps& maps, const ReportArguments& arguments) {
  const auto before = std::filesystem::path(arguments.comparison).parent_path();
  for (ComparedRun& run : comparison.runs) {
    const auto found = maps.places.find(run.name);
    if (found != maps.places.end())
      run.relativePath = seenFrom(folderOf(arguments), found->second);
    else if (!run.relativePath.empty())
      run.relativePath = seenFrom(folderOf(arguments), before / run.relativePath);
  }
}

/** Says which maps are not at hand. What was drawn of them before is not replaced by less. */
void keepOthers(const FoundMaps& maps, const Comparison& comparison,
                const ReportArguments& arguments, ResultFiles& files) {
  std::vector<std::string> missing;
  for (const ComparedRun& run : comparison.runs)
    if (maps.places.count(run.name) == 0) missing.push_back(run.file);
  if (missing.empty()) return;
  const std::vector<std::string> kept = files.keepDrawn();
  printError(arguments.comparison + ": not drawn: " + listed(missing, kMostNames) +
             (kept.empty() ? "" : ": " + listed(kept) + " stay as they were") +
             ": name the maps behind the comparison");
}

int run(const ReportArguments& arguments) {
  ResultFiles files(folderOf(arguments));
  Comparison comparison = readComparison(arguments.comparison);
  GateOptions gate = arguments.gate.limits;
  gate.candidates = candidatesOf(arguments, comparison);
  checkFiles(arguments, comparison, files);
  const FoundMaps maps = findMaps(arguments, comparison);
  keepOthers(maps, comparison, arguments, files);
  addGate(comparison, gate);
  makeWritableFolder(folderOf(arguments).string());
  tellPlaces(comparison, maps, arguments);
  StagedFiles staged;
  addResults(comparison, maps.runs, files, {}, staged);
  addGateFiles(comparison, arguments.gate, staged);
  staged.commit();
  if (!arguments.isQuiet) printResults(comparison, files, {});
  return exitCodeOf(comparison, gate);
}

}  // namespace

std::function<int()> reportCommand(CLI::App& app) {
  const auto arguments = std::make_shared<ReportArguments>();
  addArgument(app, "COMPARISON", arguments->comparison, "The comparison.json of an earlier call.");
  addOption(app, "MAP", arguments->maps,
            "Maps that were compared, or some of them, to be drawn. They are recognised by "
            "their content. Without any, those are drawn that still lie where they were "
            "compared, or beside the comparison, one folder above or in the current folder.");
  addOption(app, "-o,--output DIR", arguments->folder,
            "Folder for the results, which are those of 'roomgraph compare'. Without it, the "
            "folder of the comparison.");
  declareGate(arguments->gate, app);
  addOption(app, "--candidate NAME", arguments->candidates,
            "Let the gate judge only the run of this name; may be repeated.")
      ->allow_extra_args(false);
  declareQuiet(arguments->isQuiet, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
