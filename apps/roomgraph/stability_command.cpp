#include <algorithm>
#include <memory>

#include "commands.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/write_file.h"
#include "stability_map.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct StabilityArguments {
  std::vector<std::string> maps;
  OptionArguments options;
  StabilityTask task;
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
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  addOption(app, "--repeats N", options.repeats,
            "Number of noisy maps for each distance and percentage.")
      ->capture_default_str();
  addOption(app, "--seed S", options.seed, "Seed of the noise; the same seed gives the same files.")
      ->capture_default_str();
  addOption(app, "--match-within M", options.matchWithin,
            "How far apart a vertex and its partner may lie in the one-to-one matching [m].")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void declareRunning(StabilityTask& task, CLI::App& app) {
  declareOutput(task.folder, "X.stability.csv and X.stability.json", app);
  declareThreads(task.threads, "noisy maps", app);
  declareQuiet(task.isQuiet, app);
}

int run(const StabilityArguments& arguments) {
  StabilityTask task = arguments.task;
  task.extract = toOptions(arguments.options);
  static_cast<void>(stabilityRuns(task.options));  // throws where they make no sense
  checkOutputNames(arguments.maps, task.folder,
                   {"stability.csv", "stability.json", "stability.partial.json"});
  makeWritableFolder(task.folder);
  int exitCode = kDone;
  for (const std::string& map : arguments.maps)
    exitCode = std::max(exitCode, stabilityOfMap(map, task));
  if (!task.isQuiet)
    print(
        "The distances of the paper's text are 1, 2, 3 and 5, those of its tables are "
        "labelled 1 to 4.");
  return exitCode;
}

}  // namespace

std::function<int()> stabilityCommand(CLI::App& app) {
  const auto arguments = std::make_shared<StabilityArguments>();
  addArgument(app, "MAP", arguments->maps,
              "Maps, as for 'roomgraph extract'. They are processed one after the other, the "
              "noisy copies of each in parallel.");
  declareExperiment(arguments->task.options, app);
  declareConfig(arguments->options, app);
  declareReading(arguments->options, app);
  declareRooms(arguments->options, app);
  declareRunning(arguments->task, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
