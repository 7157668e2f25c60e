#include <memory>

#include "FleetFolder.h"
#include "commands.h"
#include "option_arguments.h"
#include "roomgraph/archive/plan_fleet.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/sentence_text.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct PlanArguments {
  std::string list, archive, folder;
  std::size_t most = PlanFleetOptions().most;
  OptionArguments options;
  bool isQuiet = false;
};

/** Throws where a file of the plan would take the place of what is not to be replaced. */
void checkFiles(const PlanArguments& arguments) {
  CallFiles files = filesReadBy({arguments.list}, arguments.options);
  files.reads(arguments.archive);
  const FleetFolder fleet(arguments.folder);
  for (const auto& file : {fleet.optionsFile(), fleet.taskFile(), fleet.failures()})
    files.writes(file.string());
}

int run(const PlanArguments& arguments) {
  PlanFleetOptions options;
  options.most = arguments.most;
  options.compare = toCompareOptions(arguments.options);
  checkFiles(arguments);
  std::vector<std::string> unread;
  options.onUnread = [&](const std::string& line) {
    printError(line);
    unread.push_back(line);
  };
  options.onMissing = [](const HistoryRun& run) {
    printError(run.file + ": note: is missing or has changed: not compared with");
  };
  const std::string folder = std::filesystem::path(arguments.list).parent_path().string();
  const RunList listed =
      readRunList(readFile(arguments.list), arguments.list, folder, options.onUnread);
  const Archive archive(arguments.archive, Archive::Access::orNew);
  const std::vector<FleetTask> tasks = planFleet(listed, archive, options);
  const FleetFolder fleet(arguments.folder);
  fleet.write(tasks, options.compare, unread);
  std::size_t news = 0;
  for (const FleetTask& task : tasks) news += task.newRuns;
  if (!arguments.isQuiet)
    print(counted(tasks.size(), "task", "tasks") + " for " + counted(news, "new run", "new runs") +
          " (of " + std::to_string(listed.size()) + " listed)\n");
  return unread.empty() ? kDone : kBadData;
}

}  // namespace

std::function<int()> planCommand(CLI::App& app) {
  const auto arguments = std::make_shared<PlanArguments>();
  addArgument(app, "LIST", arguments->list,
              "CSV file with a line per run: columns 'site' and 'file', and 'robot' and 'time' "
              "if known. File names are relative to its folder.");
  addOption(app, "--archive FILE", arguments->archive,
            "Archive of all sites; created if missing. What it knows is not done again.")
      ->required();
  addOption(app, "-o,--output DIR", arguments->folder,
            "Folder for the tasks (tasks.jsonl, a line each), the options and the results.")
      ->required();
  addOption(app, "--compare-with N", arguments->most,
            "How many runs of the archive the new ones of a site are compared with (2 to 100).")
      ->check(CLI::Range(2, 100))
      ->capture_default_str();
  declareQuiet(arguments->isQuiet, app);
  declareOptions(arguments->options, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
