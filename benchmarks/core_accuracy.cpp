// How well the figures of many runs, of which only a core is related each to each, agree with those
// of all pairs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "roomgraph/base/Error.h"
#include "roomgraph/compare/compare_maps.h"
#include "run_benchmark.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

constexpr double kSame = 0.01;  // errors that differ by less are the same [m]

struct Outcome {
  Comparison comparison;
  double seconds = 0;  ///< of CPU
};

Outcome compared(const ReadRuns& read, std::size_t core) {
  CompareMapsOptions options;
  options.compare.core = int(core);
  const std::clock_t start = std::clock();
  Outcome outcome{compareMaps(read, options), 0};
  outcome.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  return outcome;
}

const ComparedRun* find(const Comparison& comparison, const std::string& name) {
  for (const ComparedRun& run : comparison.runs)
    if (run.name == name && run.score) return &run;
  return nullptr;
}

/** Whether each figure lies in the interval of the other. */
bool agree(const RunScore& l, const RunScore& r) {
  const auto holds = [](const RunScore& score, double error) {
    return score.errorLow <= error + kSame && error <= score.errorHigh + kSame;
  };
  return holds(l, r.mapError) && holds(r, l.mapError);
}

void measureFolder(const std::string& folder, std::size_t core, bool isVerbose) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().find(".simplemap") != std::string::npos)
      files.push_back(entry.path().string());
  const ReadRuns read = readRuns(files, {});
  const Outcome all = compared(read, read.runs.size()), some = compared(read, core);
  std::size_t agreeing = 0, scored = 0;
  double farthest = 0;
  for (const ComparedRun& run : all.comparison.runs) {
    const ComparedRun* same = find(some.comparison, run.name);
    if (!run.score) continue;
    ++scored;
    if (!same) continue;
    agreeing += agree(*run.score, *same->score);
    farthest = std::max(farthest, std::abs(run.score->mapError - same->score->mapError));
    if (isVerbose)
      std::printf("%s %.3f (%.3f to %.3f), core: %.3f (%.3f to %.3f)\n", run.name.c_str(),
                  run.score->mapError, run.score->errorLow, run.score->errorHigh,
                  same->score->mapError, same->score->errorLow, same->score->errorHigh);
  }
  std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %.3f | %.1f | %.1f |\n",
              fs::path(folder).filename().c_str(), scored, core, all.comparison.pairs.size(),
              some.comparison.pairs.size(), agreeing, farthest, all.seconds, some.seconds);
  std::fflush(stdout);
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("Compares runs each with each, and with a core of them only.");
  std::vector<std::string> folders;
  std::size_t core = 12;
  bool isVerbose = false;
  app.add_option("FOLDER", folders, "folders of simplemaps, each of one site")->required();
  app.add_option("--core", core, "runs that are related each to each")
      ->check(CLI::Range(3, 1000))
      ->capture_default_str();
  app.add_flag("-v", isVerbose, "also print the figures of each run");
  return roomgraph::runBenchmark(app, argc, argv, [&] {
    std::printf(
        "| site | runs | core | pairs | pairs with a core | runs in both intervals | farthest "
        "apart "
        "[m] | CPU time, all pairs [s] | with a core [s] "
        "|\n|---|---|---|---|---|---|---|---|---|\n");
    for (const std::string& folder : folders) roomgraph::measureFolder(folder, core, isVerbose);
  });
}
