#include <memory>

#include "FleetFolder.h"
#include "commands.h"
#include "option_arguments.h"
#include "roomgraph/archive/FleetTask.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/report/comparison_json.h"
#include "run_in_order.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct TaskArguments {
  std::string folder;
  std::size_t first = 0, last = 0;
  unsigned threads = 1;  // engines give each core a task of its own
};

/** Keeps what came out, and says whether all maps could be used. */
bool keep(const FleetFolder& fleet, const FleetTask& task, const TaskResult& result) {
  const std::string document = comparisonJson(result.comparison);
  std::error_code error;
  if (result.failures.empty()) {
    writeFileAtomically(fleet.resultOf(task).string(), document);
    std::filesystem::remove(fleet.failuresOf(task), error);
    std::filesystem::remove(fleet.partOf(task), error);
    return true;
  }
  for (const std::string& line : result.failures) printError(line);
  writeFileAtomically(fleet.partOf(task).string(), document);
  writeFileAtomically(fleet.failuresOf(task).string(), linesOf(result.failures));
  return false;
}

/** Whether there is a comparison, which a crash of the disk has not cut. */
bool isWhole(const std::filesystem::path& file) {
  return orNothing([&] { return !readComparison(file.string()).runs.empty(); });
}

bool isDone(const FleetFolder& fleet, const FleetTask& task, const CompareMapsOptions& options) {
  if (isWhole(fleet.resultOf(task))) return true;
  makeWritableFolder(fleet.resultOf(task).parent_path().string());
  try {
    return keep(fleet, task, doTask(task, options));
  } catch (const DataError& failure) {
    printError(failure.what());
    writeFileAtomically(fleet.failuresOf(task).string(), linesOf({failure.what()}));
    return false;
  }
}

int run(const TaskArguments& arguments) {
  const FleetFolder fleet(arguments.folder);
  const std::vector<FleetTask> tasks = fleet.tasks();
  CompareMapsOptions options = fleet.options();
  options.compare.forEach = onThreads(arguments.threads, false);
  const std::size_t last = arguments.last == 0 ? arguments.first : arguments.last;
  if (arguments.first < 1 || arguments.first > tasks.size() || last < arguments.first)
    throw UsageError("task: there are tasks 1 to " + std::to_string(tasks.size()));
  int exitCode = kDone;
  for (std::size_t i = arguments.first; i <= last && i <= tasks.size(); ++i)
    if (!isDone(fleet, tasks[i - 1], options)) exitCode = kBadData;
  return exitCode;
}

}  // namespace

std::function<int()> taskCommand(CLI::App& app) {
  const auto arguments = std::make_shared<TaskArguments>();
  addArgument(app, "FOLDER", arguments->folder, "The folder of 'roomgraph plan'.");
  addArgument(app, "FIRST", arguments->first, "Number of the task, counted from 1.");
  addOption(app, "LAST", arguments->last, "The last task, to do several.");
  declareThreads(arguments->threads, "maps or pairs", app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
