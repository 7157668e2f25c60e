#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <memory>
#include <optional>

#include "ArchiveArguments.h"
#include "FolderWatch.h"
#include "add_to_archive.h"
#include "commands.h"
#include "output_names.h"
#include "roomgraph/archive/export_history.h"
#include "roomgraph/archive/watch_site.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/report/PairFolder.h"
#include "terminal.h"

namespace roomgraph {
namespace {

constexpr int kNoShell = 127;

/** A file without a name, which nobody has to read for the writer to go on. */
int fileWith(const std::string& content) {
  const int file = memfd_create("roomgraph", MFD_CLOEXEC);
  if (file < 0) return file;
  if (write(file, content.data(), content.size()) == ssize_t(content.size()) &&
      lseek(file, 0, SEEK_SET) == 0)
    return file;
  close(file);
  return -1;
}

/** The shell runs the command, with the signals that this program keeps back. Calls only what may
 *  be called between fork and exec. */
[[noreturn]] void runShell(const char* command, int input) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  dup2(input, STDIN_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  execl("/bin/sh", "sh", "-c", command, static_cast<char*>(nullptr));
  _exit(kNoShell);
}

/** Calls a command of the shell with `input` on its stdin, its stdout going to stderr, and waits
 *  until it ends. Its exit code, 128 and the signal where one ended it, 127 where there is no
 *  shell. */
int callCommand(const std::string& command, const std::string& input) {
  const int file = fileWith(input);
  if (file < 0) return kNoShell;
  const pid_t child = fork();
  if (child == 0) runShell(command.c_str(), file);
  close(file);
  if (child < 0) return kNoShell;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return kNoShell;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

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
    // Of this map, though later ones be known: clocks of robots err.
    const SiteHistory then = historyUpTo(archive.history(options.site), added.sha256);
    const SiteWatch site = watchSite(then, arguments.adding.watch);
    const auto isOfRobot = [&](const RobotWatch& one) { return one.robot == options.robot; };
    return addedRunJson(file, added, findIf(site.robots, isOfRobot));
  } catch (const DataError& error) {
    // A fault of the archive is none of the map: a watch that is started anew adds it.
    const std::string text = error.what();
    if (text.rfind(arguments.adding.archive + ": ", 0) == 0) throw;
    return failedRunJson(file, error.what());
  }
}

void tell(const std::string& line, const WatchArguments& arguments) {
  if (!arguments.adding.running.isQuiet) print(line + "\n");
  checkPrinted();
  if (arguments.command.empty()) return;
  const int code = callCommand(arguments.command, line + "\n");
  if (code != 0)
    printError("--exec: " + arguments.command + ": ended with " + std::to_string(code));
}

int run(const WatchArguments& arguments) {
  AddRunOptions options = addOptionsOf(arguments.adding);
  PairFolder cache(arguments.adding.cache);
  options.compare.compare.kept = cache.kept();
  options.onMissing = [](const HistoryRun&) {};  // each night anew: 'archive add' tells of it
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
  addArgument(app, "DIR", arguments->folder,
              "Folder that maps are written to. Those that are there already are added, too, if "
              "the archive does not know them. Bare pictures count only beside the yaml of a ROS "
              "map, and folders in it do not count.");
  addOption(app, "--archive FILE", arguments->adding.archive,
            "The archive that they are added to (SQLite); created if missing.")
      ->required();
  addOption(app, "--exec CMD", arguments->command,
            "Call this command of the shell for each map, with its line on stdin. The next map "
            "waits until it ends.");
  declareWatch(arguments->adding, app);
  declareAdding(arguments->adding, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
