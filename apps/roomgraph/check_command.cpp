#include <memory>
#include <optional>

#include "Laps.h"
#include "ResultFolder.h"
#include "commands.h"
#include "more_files.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/page/check_page.h"
#include "roomgraph/report/gate_report.h"
#include "roomgraph/report/run_check_json.h"
#include "run_in_order.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct CheckArguments {
  std::vector<std::string> files;
  OptionArguments options;
  std::string folder;
  CheckGateOptions gate;
  std::string junit, summary;  ///< files; empty for none
  bool writesBreaks = false;
  RunningArguments running;
};

constexpr char kNoUseForResolution[] =
    "what scans tell of a run does not depend on --resolution: it was not used";

void declareCheckGate(CheckArguments& arguments, CLI::App& app) {
  addOption(app, "--fail-above M", arguments.gate.maxError,
            "Exit with 3 if a run has a self error above this [m], or none.")
      ->check(isWithin(0, 1e6));
  CheckGateOptions& gate = arguments.gate;
  declareFailOn({{"broken", &gate.failsOnBreaks}, {"doubled", &gate.failsOnDoubled}},
                "Exit with 3 on any of these, comma separated: 'broken' (a run has a break), "
                "'doubled' (it has drawn a place twice, or laid one over another).",
                app);
  addOption(app, "--junit FILE", arguments.junit,
            "Also write the verdict of the gate as JUnit XML, for CI systems.");
  addOption(app, "--summary FILE", arguments.summary,
            "Also write a table of the runs, with the verdict of the gate, as Markdown.");
}

/** Writes the results of a run. Returns their names. */
std::vector<std::string> writeResults(const RunCheck& check, const Run& run,
                                      const std::string& folder, const LoadGridOptions* logs) {
  FolderFiles files{folder};
  const std::string stem = mapStem(run.file) + ".check";
  files.add(stem + ".json", runCheckJson(check));
  files.add(stem + ".html", checkPage(check, run));
  if (logs) addCheckLogs(check, *logs, stem, files);
  files.staged.commit();
  return files.names;
}

/** Checks one run, and writes what it tells of itself. */
void checkFile(const std::string& file, const CheckArguments& arguments,
               std::optional<RunCheck>& check, UnusedOptions& unused, JobReport& report) {
  CompareMapsOptions options = toCompareOptions(arguments.options);
  std::vector<MapNote> notes;
  options.onNote = [&](const std::string& noted, const Note& note) {
    if (!unused.take(note)) notes.push_back({noted, note});
  };
  Laps laps;
  const Run run = readRun(file, options);
  laps.end("read_run");
  if (!run.scans.empty() && options.extract.loadGrid.isResolutionGiven)
    (void)unused.take({kUnusedOption, kNoUseForResolution, {}});
  report.err += noteLines(notes, arguments.running);
  check = checkRun(run);
  check->complaints = complaintsOf(*check, arguments.gate);
  laps.end("check_run");
  const auto names = writeResults(*check, run, arguments.folder,
                                  arguments.writesBreaks ? &options.extract.loadGrid : nullptr);
  laps.end("write_files");
  if (arguments.running.showsTimings) report.err += laps.table(file);
  if (!arguments.running.isQuiet) report.out = runCheckText(*check) + fileLines(names);
  for (const std::string& complaint : check->complaints)
    report.err += errorLine(check->name + ": " + complaint);
}

/** Throws where a result would take the place of what is not to be replaced. */
void checkFiles(const CheckArguments& arguments) {
  CallFiles files = filesReadBy(arguments.files, arguments.options);
  files.writesOfEach(arguments.files, arguments.folder, {"check.json", "check.html"});
  files.writesTo("--junit", arguments.junit);
  files.writesTo("--summary", arguments.summary);
  if (!arguments.writesBreaks) return;
  for (const std::string& file : arguments.files)
    for (const char* kind : {"check.break", "check.doubled", "check.welded"})
      files.writesNumbered(outputFile(arguments.folder, file, kind), file);
}

int run(const CheckArguments& arguments) {
  checkFiles(arguments);
  const ResultFolder folder(arguments.folder);
  std::vector<std::optional<RunCheck>> found(arguments.files.size());
  UnusedOptions unused;
  const auto checkOne = [&](std::size_t index, JobReport& report) {
    checkFile(arguments.files[index], arguments, found[index], unused, report);
  };
  const JobList jobs{found.size(), checkOne,
                     [&](std::size_t index) { return arguments.files[index]; }};
  const int exitCode = runInOrder(jobs, arguments.running.threads, !arguments.running.isQuiet);
  unused.tell(arguments.files.size());
  std::vector<RunCheck> checks;
  std::vector<std::string> unread;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i])
      checks.push_back(std::move(*found[i]));
    else
      unread.push_back(arguments.files[i]);
  }
  if (!arguments.junit.empty()) writeFileAtomically(arguments.junit, gateJunit(checks, unread));
  if (!arguments.summary.empty())
    writeFileAtomically(arguments.summary, gateMarkdown(checks, unread));
  const bool fails = anyOf(checks, [](const RunCheck& check) { return !check.complaints.empty(); });
  return fails ? kGateFailed : exitCode;
}

}  // namespace

std::function<int()> checkCommand(CLI::App& app) {
  const auto arguments = std::make_shared<CheckArguments>();
  addArgument(app, "RUN", arguments->files,
              "Runs to check, each by itself: simplemaps with 2D scans or point clouds. For "
              "other maps, only what their walls show is reported, without an error.");
  declareOutput(arguments->folder, "X.check.json and X.check.html", app);
  app.add_flag(
      "--break-files", arguments->writesBreaks,
      "Also write the scans of each break N, of each place N that is drawn twice and of each "
      "that lies over another, for RawLogViewer: X.check.breakN.rawlog, "
      "X.check.doubledN.rawlog and X.check.weldedN.rawlog as the run has them, and "
      ".untorn.rawlog as they fit.");
  declareCheckGate(*arguments, app);
  declareOptions(arguments->options, app);
  declareRunning(arguments->running, "runs", "every note on a map", app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
