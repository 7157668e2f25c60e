#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>

#include "ResultFolder.h"
#include "commands.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/evaluation/write_stability.h"
#include "roomgraph/map_files/load_grid.h"
#include "run_in_order.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct StabilityArguments {
  std::vector<std::string> maps;
  OptionArguments options;
  StabilityOptions experiment;
  std::string folder;    ///< for the results
  unsigned threads = 0;  ///< noisy maps at the same time; 0 for one per core
  bool isQuiet = false;
};

void declareExperiment(StabilityOptions& options, CLI::App& app) {
  addOption(app, "--distances LIST", options.distances,
            "How far from a wall new cells may lie, in cells per axis, as a comma-separated list.")
      ->delimiter(',')
      ->capture_default_str();
  addOption(app, "--percents LIST", options.percents,
            "Percentages of the occupied cells that move, as a comma-separated list.")
      ->delimiter(',')
      ->capture_default_str();
  addOption(app, "--base-distance CELLS", options.baseDistance,
            "How far new cells may lie in the map that all others are compared with.")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addOption(app, "--base-percent P", options.basePercent,
            "Percentage of the occupied cells that move in that map.")
      ->check(isWithin(0, 100))
      ->capture_default_str();
  addOption(app, "--repeats N", options.repeats,
            "Number of noisy maps for each distance and percentage.")
      ->capture_default_str();
  addOption(app, "--seed S", options.seed, "Seed of the noise; the same seed gives the same files.")
      ->check(isWithin(0, 1e19))
      ->capture_default_str();
  addOption(app, "--match-within M", options.matchWithin,
            "How far apart a vertex and its partner may lie in the one-to-one matching [m].")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

/** The runs that are done, in memory and on the disk. Used by all threads. */
class Progress {
 public:
  Progress(std::string file, std::string key, std::vector<StabilityRun> runs)
      : file_(std::move(file)), key_(std::move(key)), runs_(std::move(runs)) {
    const std::string kept = orNothing([&] { return readFile(file_); });  // else all is done anew
    done_ = readProgress(kept, key_, runs_);
  }

  /** Places in the list of runs. */
  std::vector<std::size_t> pending() const {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < done_.size(); ++i)
      if (!done_[i]) places.push_back(i);
    return places;
  }

  const StabilityRun& run(std::size_t place) const { return runs_[place]; }

  void add(std::size_t place, const RunMeasures& measures) {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_[place] = measures;
    const auto now = Clock::now();
    if (isSaved_ && now - lastSaved_ < std::chrono::seconds(1)) return;
    writeFileAtomically(file_, progressText(key_, runs_, done_));
    isSaved_ = true;
    lastSaved_ = now;
  }

  /** Only when nothing is pending. */
  std::vector<RunMeasures> all() const {
    return mapped(done_, [](const auto& one) { return one.value(); });
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::string file_, key_;
  std::vector<StabilityRun> runs_;
  RunsDone done_;
  std::mutex mutex_;
  bool isSaved_ = false;
  Clock::time_point lastSaved_;
};

int measurePending(const StabilityBase& base, Progress& progress, const std::string& mapFile,
                   const StabilityArguments& arguments) {
  const std::vector<std::size_t> pending = progress.pending();
  const auto measure = [&](std::size_t job, JobReport&) {
    progress.add(pending[job], measureRun(base, progress.run(pending[job])));
  };
  return runInOrder({pending.size(), measure, [&](std::size_t) { return mapFile; }},
                    arguments.threads, !arguments.isQuiet);
}

std::string summary(const Stability& result) {
  return std::to_string(result.rows.size()) + " rows of " + std::to_string(result.options.repeats) +
         " noisy maps, seed " + std::to_string(result.options.seed) + "; the base map has " +
         std::to_string(result.baseRooms) + " rooms\n" + stabilityText(result);
}

/** Does the whole experiment with one map, writes its files and prints its table. What an
 *  interrupted run of the same map and options has left in X.stability.partial.json is not computed
 *  again; that file goes once the results are written. */
int measureMap(const std::string& mapFile, const StabilityArguments& arguments,
               const ExtractOptions& extract) {
  const std::string partial = outputFile(arguments.folder, mapFile, "stability.partial.json");
  const std::string csv = outputFile(arguments.folder, mapFile, "stability.csv");
  const std::string json = outputFile(arguments.folder, mapFile, "stability.json");
  const GreyMap map = loadGrid(mapFile, extract.loadGrid);
  printWarnings(mapFile, map.notes);
  Progress progress(partial, stabilityKey(map.source, extract, arguments.experiment),
                    stabilityRuns(arguments.experiment));
  const StabilityBase base = stabilityBase(map, extract, arguments.experiment);
  const int exitCode = measurePending(base, progress, mapFile, arguments);
  if (exitCode != kDone) return exitCode;
  const Stability result = summarizeStability(map, base, arguments.experiment, progress.all());
  StagedFiles files;
  files.add(csv, stabilityCsv(result));
  files.add(json, stabilityJson(result));
  files.commit();
  std::error_code gone;  // a file that is left does no harm
  std::filesystem::remove(partial, gone);
  if (!arguments.isQuiet)
    print(printable(mapFile) + ": " + summary(result) + printable(csv) + "\n" + printable(json) +
          "\n");
  return kDone;
}

int run(const StabilityArguments& arguments) {
  const ExtractOptions extract = toOptions(arguments.options);
  static_cast<void>(stabilityRuns(arguments.experiment));  // throws where they make no sense
  filesReadBy(arguments.maps, arguments.options)
      .writesOfEach(arguments.maps, arguments.folder,
                    {"stability.csv", "stability.json", "stability.partial.json"});
  const ResultFolder folder(arguments.folder);
  int worst = kDone;
  const int exitCode = doEach(arguments.maps, [&](const std::string& map) {
    worst = std::max(worst, measureMap(map, arguments, extract));
  });
  if (!arguments.isQuiet)
    print(
        "The distances of the paper's text are 1, 2, 3 and 5, those of its tables are "
        "labelled 1 to 4.");
  return std::max(exitCode, worst);
}

}  // namespace

std::function<int()> stabilityCommand(CLI::App& app) {
  const auto arguments = std::make_shared<StabilityArguments>();
  addArgument(app, "MAP", arguments->maps,
              "Maps, as for 'roomgraph extract'. They are processed one after the other, the "
              "noisy copies of each in parallel.");
  declareExperiment(arguments->experiment, app);
  declareOptions(arguments->options, app);
  declareRooms(arguments->options, app);
  declareOutput(arguments->folder, "X.stability.csv and X.stability.json", app);
  declareThreads(arguments->threads, "noisy maps", app);
  declareQuiet(arguments->isQuiet, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
