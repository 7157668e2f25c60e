#include "collect_command.h"

#include <memory>

#include "Command.h"
#include "FleetFolder.h"
#include "comparison_results.h"
#include "option_arguments.h"
#include "roomgraph/archive/Archive.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/files/InputFile.h"
#include "roomgraph/report/comparison_json.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct CollectArguments {
  std::string folder, archive;
  bool isQuiet = false;
};

/** What became of a task: runs that are new in the archive, and why some are not. */
struct Collected {
  std::size_t runs = 0;
  std::vector<std::string> failures;
};

std::vector<std::string> failuresOf(const FleetFolder& fleet, const FleetTask& task) {
  std::vector<std::string> lines;
  const std::string text = readFile(fleet.failuresOf(task).string());
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

Collected collect(const FleetFolder& fleet, const FleetTask& task, Archive& archive) {
  Collected collected;
  std::error_code error;
  const bool isWhole = std::filesystem::exists(fleet.resultOf(task), error);
  if (!isWhole && std::filesystem::exists(fleet.failuresOf(task), error))
    collected.failures = failuresOf(fleet, task);
  else if (!isWhole)
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
  if (!arguments.isQuiet)
    print(std::to_string(tasks.size() - failed) + " of " + std::to_string(tasks.size()) +
          " tasks are done, " + std::to_string(news) + " runs are new in the archive\n");
  return failed == 0 ? kDone : kBadData;
}

}  // namespace

std::function<int()> collectCommand(CLI::App& app) {
  const auto arguments = std::make_shared<CollectArguments>();
  app.add_option("FOLDER", arguments->folder, "The folder of 'roomgraph plan', after its tasks.")
      ->type_name("")
      ->required();
  app.add_option("--archive", arguments->archive, "The archive that the plan was made with.")
      ->type_name("FILE")
      ->required();
  declareQuiet(arguments->isQuiet, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
