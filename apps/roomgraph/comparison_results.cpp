#include "comparison_results.h"

#include <cmath>
#include <utility>

#include "commands.h"
#include "option_arguments.h"
#include "output_formats.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/mrpt_plugin/comparison_scene.h"
#include "roomgraph/mrpt_plugin/map_comparison_file.h"
#include "roomgraph/page/comparison_report.h"
#include "roomgraph/report/comparison_csv.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/comparison_sentences.h"
#include "roomgraph/report/gate_report.h"
#include "roomgraph/report/site_json.h"
#include "terminal.h"

namespace roomgraph {

struct ComparisonFile {
  const char *format, *name;  ///< for --format; of the file
  bool drawsMaps;
  std::string (*bytes)(const Comparison& saved, const std::vector<Run>& runs);
};

namespace {

using Runs = std::vector<Run>;

constexpr ComparisonFile kFiles[] = {
    {"report", "report.html", true,
     [](const Comparison& c, const Runs& r) { return comparisonReport(c, r); }},
    {"json", "comparison.json", false,
     [](const Comparison& c, const Runs&) { return comparisonJson(c); }},
    {"csv", "comparison.runs.csv", false,
     [](const Comparison& c, const Runs&) { return comparisonRunsCsv(c); }},
    {"csv", "comparison.rooms.csv", false,
     [](const Comparison& c, const Runs&) { return comparisonRoomsCsv(c); }},
    {"geojson", "comparison.rooms.geojson", false,
     [](const Comparison& c, const Runs&) { return siteGeojson(c); }},
    {"3Dscene", "comparison.3Dscene", true,
     [](const Comparison& c, const Runs& r) { return comparisonSceneBytes(c, r); }},
    {"roomgraph", "comparison.roomgraph", true,
     [](const Comparison& c, const Runs& r) { return mapComparisonBytes(CMapComparison(c, r)); }},
};

/** The format of a file for each run, which "all" leaves out. */
constexpr char kTrajectories[] = "evo";

std::vector<std::string> allFormats() {
  std::vector<std::string> names;
  for (const ComparisonFile& file : kFiles)
    if (names.empty() || names.back() != file.format) names.emplace_back(file.format);
  return names;
}

}  // namespace

ResultFiles::ResultFiles(std::filesystem::path folder, const std::string& formats)
    : folder_(std::move(folder)) {
  const std::vector<std::string> chosen = chosenFormats(formats, allFormats(), {kTrajectories});
  for (const ComparisonFile& file : kFiles)
    if (contains(chosen, file.format)) files_.push_back(&file);
  hasTrajectories_ = contains(chosen, kTrajectories);
}

std::string ResultFiles::nameOf(const ComparisonFile& file) const {
  return (folder_ / file.name).string();
}

std::vector<std::string> ResultFiles::keepDrawn() {
  std::vector<std::string> kept;
  const auto isKept = [&](const ComparisonFile* file) {
    std::error_code error;
    if (!file->drawsMaps || !std::filesystem::exists(nameOf(*file), error)) return false;
    kept.emplace_back(file->name);
    return true;
  };
  eraseIf(files_, isKept);
  return kept;
}

std::vector<std::string> ResultFiles::names() const {
  return mapped(files_, [this](const ComparisonFile* file) { return nameOf(*file); });
}

void ResultFiles::add(const Comparison& saved, const std::vector<Run>& runs,
                      StagedFiles& staged) const {
  for (const ComparisonFile* file : files_) staged.add(nameOf(*file), file->bytes(saved, runs));
}

std::string listedFiles() {
  return listed(mapped(kFiles, [](const ComparisonFile& file) { return std::string(file.name); }));
}

void declareFormats(std::string& formats, CLI::App& app) {
  addOption(
      app, "--format LIST", formats,
      "What to write, as a comma-separated list: " + listedFormats(allFormats(), {kTrajectories}) +
          ". 'evo', which 'all' does not include, writes for each run with scans its path in "
          "the frame of the site (comparison.RUN.tum) and the error along it for "
          "evo_res (comparison.RUN.evo.zip).")
      ->capture_default_str();
}

void declareGate(GateArguments& arguments, CLI::App& app) {
  const std::string nearlyAll = std::to_string(std::lround(100 * kNearlyAll));
  addOption(app, "--fail-below SCORE", arguments.limits.minScore,
            "Exit with 3 if a run has a score below this (0 to 100), or none that can be trusted.")
      ->check(isWithin(0, 100));
  addOption(app, "--fail-above M", arguments.limits.maxError,
            "Exit with 3 if a run has a map error above this [m], or none that can be trusted.")
      ->check(isWithin(0, 1e6));
  addOption(app, "--fail-worse-by M", arguments.limits.maxWorse,
            "Exit with 3 if the map error of a run exceeds the median of the three best other "
            "runs by more than this [m], or cannot be trusted.")
      ->check(isWithin(0, 1e6));
  GateOptions& gate = arguments.limits;
  declareFailOn({{"broken", &gate.failsOnBreaks},
                 {"unconfirmed", &gate.failsOnUnconfirmed},
                 {"coverage", &gate.failsOnCoverage},
                 {"not-same-site", &gate.failsOnOtherSites},
                 {"walls", &gate.failsOnWalls}},
                "Exit with 3 on any of these, separated by commas: 'coverage' (a run has seen "
                "less than " +
                    nearlyAll +
                    " % of what at least two runs have seen), 'broken' (a run has a break that is "
                    "not slight, or is smeared), 'unconfirmed' (other runs confirm less than " +
                    nearlyAll +
                    " % of what a run has drawn, or contradict some of it), 'not-same-site' (a "
                    "run is of another site, or mirrored), 'walls' (a run lacks walls that others "
                    "have, has walls that they do not have, or draws all thinner or thicker).",
                app);
  addOption(app, "--junit FILE", arguments.junit,
            "Also write the verdict of the gate as JUnit XML, for CI systems.");
  addOption(app, "--summary FILE", arguments.summary,
            "Also write the ranking and the verdict of the gate as Markdown, for CI systems.");
}

void addGateFiles(const Comparison& comparison, const GateArguments& arguments,
                  StagedFiles& staged) {
  if (!arguments.junit.empty()) staged.add(arguments.junit, gateJunit(comparison));
  if (!arguments.summary.empty()) staged.add(arguments.summary, gateMarkdown(comparison));
}

bool addGate(Comparison& comparison, const GateOptions& gate) {
  if (gate.asksNothing()) return false;
  comparison.gate = gateVerdict(comparison, gate);
  return !comparison.gate->isPassed();
}

std::string seenFrom(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::relative(file, folder, error).generic_string();
}

void addResults(Comparison comparison, const std::vector<Run>& runs, const ResultFiles& files,
                const std::vector<std::string>& more, StagedFiles& staged) {
  comparison.files.clear();
  for (const std::vector<std::string>& names : {files.names(), more})
    for (const std::string& name : names) comparison.files.push_back(fileName(name));
  // All is made from what is saved, with its rounding, so that it can be made anew.
  files.add(parseComparisonJson(comparisonJson(comparison), "comparison.json"), runs, staged);
}

void printResults(const Comparison& comparison, const ResultFiles& files,
                  const std::vector<std::string>& more) {
  std::string text = comparisonText(comparison) + printable(comparison.verdict) + "\n";
  for (const std::string& sentence :
       {refutedSentence(comparison), breaksSentence(comparison), doubtSentence(comparison)})
    if (!sentence.empty()) text += printable(sentence) + "\n";
  text += fileLines(files.names()) + fileLines(more);
  if (comparison.gate) text += printable(gateLine(*comparison.gate)) + "\n";
  print(text);
}

void printMaps(const std::vector<Run>& runs) {
  for (const Run& run : runs)
    printError(run.file + ": " + formatted("cells of %g m, ", run.resolution) +
               counted(run.map.walls.size(), "point of wall", "points of wall") + ", " +
               counted(run.rooms.size(), "room", "rooms") + ", " +
               counted(run.scans.size(), "scan", "scans"));
}

int exitCodeOf(const Comparison& comparison, const GateOptions& gate) {
  const bool gateFails = comparison.gate && !comparison.gate->isPassed();
  if (gateFails)
    for (const std::string& line : comparison.gate->complaints) printError(line);
  const bool isCompared =
      anyOf(comparison.runs, [](const ComparedRun& run) { return run.score.has_value(); });
  const bool areSeveralSites = anyOf(comparison.leftOut, &LeftOutRun::isOtherSite);
  const bool isAskedForSites = gate.failsOnOtherSites && areSeveralSites;
  if (gateFails && (isCompared || isAskedForSites)) return kGateFailed;
  if (isCompared) return kDone;
  const char* reason = comparison.areCopies()       ? "all maps are copies of one"
                       : comparison.runs.size() > 1 ? "no walls could be followed from map to map"
                       : areSeveralSites            ? "no two maps lie in one site"
                                                    : "only one map could be used";
  printError(std::string("compare: nothing was compared: ") + reason);
  return kBadData;
}

}  // namespace roomgraph
