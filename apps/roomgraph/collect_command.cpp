#include <memory>

#include "FleetFolder.h"
#include "commands.h"
#include "option_arguments.h"
#include "roomgraph/archive/Archive.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/report/comparison_json.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct CollectArguments {
  std::string folder, archive;
  bool isQuiet = false;
};

/** "39 of 40 tasks are done, 119 runs are new in the archive". */
std::string summary(std::size_t done, std::size_t tasks, std::size_t news) {
  return std::to_string(done) + " of " + counted(tasks, "task", "tasks") +
         (done == 1 || tasks == 1 ? " is done, " : " are done, ") + counted(news, "run", "runs") +
         (news == 1 ? " is" : " are") + " new in the archive\n";
}

/** What became of a task: runs that are new in the archive, and why some are not. */
struct Collected {
  std::size_t runs = 0;
  std::vector<std::string> failures;
};

Collected collect(const FleetFolder& fleet, const FleetTask& task, Archive& archive) {
  Collected collected;
  std::error_code error;
  const bool isWhole = std::filesystem::exists(fleet.resultOf(task), error);
  if (!isWhole) collected.failures = FleetFolder::failuresIn(fleet.failuresOf(task));
  if (!isWhole && collected.failures.empty())
    collected.failures = {"has not been done: start its task again"};
  if (!isWhole && !std::filesystem::exists(fleet.partOf(task), error)) return collected;
  Addition addition;
  addition.site = task.site;
  addition.runs = {task.runs.begin(), task.runs.begin() + std::ptrdiff_t(task.newRuns)};
  addition.comparison =
      readComparison((isWhole ? fleet.resultOf(task) : fleet.partOf(task)).string());
  const Added added = archive.record(addition);
  collected.runs = added.runs;
  if (!added.roomsFailed.empty()) collected.failures.push_back(added.roomsFailed);
  return collected;
}

int run(const CollectArguments& arguments) {
  const FleetFolder fleet(arguments.folder);
  Archive archive(arguments.archive, Archive::Access::existing);
  const std::vector<FleetTask> tasks = fleet.tasks();
  // What never became a task: the call is the only one of a night whose exit code is looked at.
  const std::vector<std::string> unplanned = FleetFolder::failuresIn(fleet.failures());
  for (const std::string& line : unplanned) printError(line);
  std::size_t failed = 0, news = 0;
  for (const FleetTask& task : tasks) {
    Collected collected;
    try {
      collected = collect(fleet, task, archive);
    } catch (const DataError& error) {
      collected.failures.push_back(error.what());
    }
    news += collected.runs;
    if (!collected.failures.empty()) ++failed;
    for (const std::string& line : collected.failures) printError(task.site + ": " + line);
  }
  if (!arguments.isQuiet) print(summary(tasks.size() - failed, tasks.size(), news));
  return failed == 0 && unplanned.empty() ? kDone : kBadData;
}

}  // namespace

std::function<int()> collectCommand(CLI::App& app) {
  const auto arguments = std::make_shared<CollectArguments>();
  addArgument(app, "FOLDER", arguments->folder, "The folder of 'roomgraph plan', after its tasks.");
  addOption(app, "--archive FILE", arguments->archive, "The archive that the plan was made with.")
      ->required();
  declareQuiet(arguments->isQuiet, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
