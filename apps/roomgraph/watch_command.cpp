#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "ArchiveArguments.h"
#include "FolderWatch.h"
#include "add_to_archive.h"
#include "call_command.h"
#include "commands.h"
#include "comparison_results.h"
#include "output_names.h"
#include "roomgraph/archive/added_run_json.h"
#include "roomgraph/archive/watch_site.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/report/PairFolder.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct WatchArguments {
  ArchiveArguments adding;
  std::string folder, command;
};

/** What becomes of a map, as a line; none where the archive knows it already. */
std::optional<std::string> lineOf(const std::string& file, const WatchArguments& arguments,
                                  AddRunOptions options) {
  try {
    Archive archive(arguments.adding.archive, Archive::Access::orNew);
    options.site = siteToAddTo(arguments.adding, archive);
    const AddedRun added = addRun(archive, file, options);
    if (added.wasKnown) return {};
    if (!added.roomsFailed.empty()) printError(added.roomsFailed);
    const SiteWatch site = watchSite(archive.history(options.site), arguments.adding.watch);
    const auto robot =
        std::find_if(site.robots.begin(), site.robots.end(),
                     [&](const RobotWatch& one) { return one.robot == options.robot; });
    return addedRunJson(file, added, robot == site.robots.end() ? nullptr : &*robot);
  } catch (const DataError& error) {
    return failedRunJson(file, error.what());
  }
}

void tell(const std::string& line, const WatchArguments& arguments) {
  print(line + "\n");
  checkPrinted();
  if (arguments.command.empty()) return;
  const int code = callCommand(arguments.command, line + "\n");
  if (code != 0)
    printError("--exec: " + arguments.command + ": ended with " + std::to_string(code));
}

int run(const WatchArguments& arguments) {
  AddRunOptions options = addOptionsOf(arguments.adding);
  std::optional<PairFolder> cache;
  if (!arguments.adding.cache.empty())
    options.compare.compare.kept = cache.emplace(arguments.adding.cache).kept();
  options.onMissing = [](const KnownRun&) {};  // each night anew: 'archive add' tells of it
  FolderWatch folder(arguments.folder);
  siteToAddTo(arguments.adding, Archive(arguments.adding.archive, Archive::Access::orNew));
  for (;;) {
    const std::string file = folder.next();
    if (wouldBeSameFile(file, arguments.adding.archive)) continue;
    if (const auto line = lineOf(file, arguments, options)) tell(*line, arguments);
  }
}

}  // namespace

std::function<int()> watchCommand(CLI::App& app) {
  const auto arguments = std::make_shared<WatchArguments>();
  arguments->adding.isQuiet = true;
  app.add_option(
         "DIR", arguments->folder,
         "Folder that maps are written to. Those that are there already are added, too, if "
         "the archive does not know them. Bare pictures count only beside the yaml of a ROS "
         "map, and folders in it do not count.")
      ->type_name("")
      ->required();
  app.add_option("--archive", arguments->adding.archive,
                 "The archive that they are added to (SQLite); created if missing.")
      ->type_name("FILE")
      ->required();
  app.add_option(
         "--exec", arguments->command,
         "Call this command of the shell for each map, with its line on stdin. The next map "
         "waits until it ends.")
      ->type_name("CMD");
  declareWatch(arguments->adding, app);
  declareAdding(arguments->adding, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
