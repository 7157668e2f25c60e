#include "stability_map.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <mutex>

#include "commands.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/evaluation/stability_progress.h"
#include "roomgraph/evaluation/write_stability.h"
#include "roomgraph/map_files/load_grid.h"
#include "run_in_order.h"
#include "terminal.h"

namespace roomgraph {
namespace {

std::string textOf(const std::string& file) {
  try {
    return readFile(file);
  } catch (const DataError&) {
    return {};  // the runs are done anew
  }
}

/** The runs that are done, in memory and on the disk. Used by all threads. */
class Progress {
 public:
  Progress(std::string file, std::string key, std::vector<StabilityRun> runs)
      : file_(std::move(file)), key_(std::move(key)), runs_(std::move(runs)) {
    done_ = readProgress(textOf(file_), key_, runs_);
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
    std::vector<RunMeasures> measures;
    for (const auto& one : done_) measures.push_back(one.value());
    return measures;
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
                   const StabilityTask& task) {
  const std::vector<std::size_t> pending = progress.pending();
  JobList jobs;
  jobs.count = pending.size();
  jobs.run = [&](std::size_t job, const std::function<void()>& stepDone) {
    JobReport report;
    try {
      progress.add(pending[job], measureRun(base, progress.run(pending[job])));
    } catch (...) {
      const Failure failure = currentFailure(mapFile);
      report.err = failure.line;
      report.exitCode = failure.exitCode;
    }
    stepDone();
    return report;
  };
  return runInOrder(jobs, task.threads, !task.isQuiet);
}

std::string summary(const Stability& result) {
  return std::to_string(result.rows.size()) + " rows of " + std::to_string(result.options.repeats) +
         " noisy maps, seed " + std::to_string(result.options.seed) + "; the base map has " +
         std::to_string(result.baseRooms) + " rooms\n" + stabilityText(result);
}

int measureMap(const std::string& mapFile, const StabilityTask& task) {
  const std::string partial = outputFile(task.folder, mapFile, "stability.partial.json");
  const std::string csv = outputFile(task.folder, mapFile, "stability.csv");
  const std::string json = outputFile(task.folder, mapFile, "stability.json");
  const GreyMap map = loadGrid(mapFile, task.extract.loadGrid);
  Progress progress(partial, stabilityKey(map.source, task.extract, task.options),
                    stabilityRuns(task.options));
  const StabilityBase base = stabilityBase(map, task.extract, task.options);
  const int exitCode = measurePending(base, progress, mapFile, task);
  if (exitCode != kDone) return exitCode;
  const Stability result = summarizeStability(map, base, task.options, progress.all());
  StagedFiles files;
  files.add(csv, stabilityCsv(result));
  files.add(json, stabilityJson(result));
  files.commit();
  std::error_code gone;  // a file that is left does no harm
  std::filesystem::remove(partial, gone);
  if (!task.isQuiet)
    print(printable(mapFile) + ": " + summary(result) + printable(csv) + "\n" + printable(json) +
          "\n");
  return kDone;
}

}  // namespace

int stabilityOfMap(const std::string& mapFile, const StabilityTask& task) {
  try {
    return measureMap(mapFile, task);
  } catch (...) {
    const Failure failure = currentFailure(mapFile);
    std::fputs(failure.line.c_str(), stderr);
    return failure.exitCode;
  }
}

}  // namespace roomgraph
