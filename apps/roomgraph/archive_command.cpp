#include <memory>

#include "ArchiveArguments.h"
#include "CallFiles.h"
#include "add_to_archive.h"
#include "commands.h"
#include "option_arguments.h"
#include "roomgraph/archive/Archive.h"
#include "roomgraph/archive/export_history.h"
#include "roomgraph/archive/history_page.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/base/write_file.h"
#include "terminal.h"

namespace roomgraph {
namespace {

void declareAdd(ArchiveArguments& arguments, CLI::App& app) {
  addArgument(app, "RUN", arguments.files, "Maps of one site, as for 'roomgraph compare'.");
  addOption(app, "--time T", arguments.time,
            "When they were made, in UTC, such as 2026-11-22 or 2026-11-22T03:00. Without it, "
            "the time of the first scan, or else that of the file.");
  declareAdding(arguments, app);
  app.add_flag("--repair", arguments.repairs,
               "Keep each run as it is mended, too, beside its copy (needs --keep): "
               "X.repaired.simplemap, see 'roomgraph repair'.");
}

void declareMerge(ArchiveArguments& arguments, CLI::App& app) {
  declareSite(arguments, app);
  addOption(app, "--runs N", arguments.most,
            "How many runs are merged (2 to 100): half of them the latest, the others the best.")
      ->check(CLI::Range(2, 100))
      ->capture_default_str();
  declareMerging(arguments, app);
}

void declareNaming(ArchiveArguments& arguments, CLI::App& app) {
  addArgument(app, "ROOM", arguments.room, "Its id, such as R3, as 'rooms' lists them.");
  addArgument(app, "NAME", arguments.name, "The name that it is to have from now on.");
  declareSite(arguments, app);
}

void declareRemoving(ArchiveArguments& arguments, CLI::App& app) {
  addArgument(app, "RUN", arguments.run,
              "Its file as 'list' names it, with or without the folder, or at least eight digits "
              "of its SHA-256.");
  declareSite(arguments, app);
}

void declareRenaming(ArchiveArguments& arguments, CLI::App& app) {
  addArgument(app, "ROBOT", arguments.robot, "Its name, as 'list' tells it.");
  addArgument(app, "NAME", arguments.name, "The name that its runs are to have.");
  declareSite(arguments, app);
}

void declareReport(ArchiveArguments& arguments, CLI::App& app) {
  declareSite(arguments, app);
  declareWatch(arguments, app);
  addOption(app, "-o,--output FILE", arguments.page,
            "Also write the report as a page for the browser, with plots.");
  declareQuiet(arguments.running.isQuiet, app);
  app.add_flag("--fail-on-alarm", arguments.failsOnAlarm,
               "Exit with 3 if the maps of a robot get worse, or tell nothing of the site two "
               "nights in a row, with a line on stderr for each.");
  app.add_flag("--fail-on-latest", arguments.failsOnLatest,
               "Exit with 3 if the latest map of a robot may not be rolled out, with a line on "
               "stderr for each.");
}

void declareExport(ArchiveArguments& arguments, CLI::App& app) {
  declareSite(arguments, app);
  declareWatch(arguments, app);
  addOption(app, "--format F", arguments.format,
            "What to write: 'csv' (a line per run), 'json' (all that is known) or 'prometheus' (a "
            "text file for node_exporter).")
      ->check(CLI::IsMember({"csv", "json", "prometheus"}))
      ->capture_default_str();
  addOption(app, "-o,--output FILE", arguments.output, "File to write. Without it, to stdout.");
}

/** The site that is asked for, or all. */
std::vector<WatchedSite> sitesToTell(const ArchiveArguments& arguments) {
  const Archive archive(arguments.archive, Archive::Access::existing);
  std::vector<std::string> sites = archive.sites();
  if (!arguments.site.empty()) {
    if (!contains(sites, arguments.site))
      throw UsageError(arguments.archive + ": has no site " + arguments.site +
                       ": 'list' names those that it has");
    sites = {arguments.site};
  }
  std::vector<WatchedSite> told;
  for (const std::string& site : sites) {
    WatchedSite one;
    one.history = archive.history(site);
    one.watch = watchSite(one.history, arguments.watch);
    told.push_back(std::move(one));
  }
  if (told.empty() && !arguments.running.isQuiet)
    printError(arguments.archive + ": note: has no runs yet: add some");
  return told;
}

/** One map of the runs, with the names that the archive knows; it changes nothing in it. */
int mergeRunsOf(const ArchiveArguments& arguments) {
  MergeArguments merge = arguments;
  const Archive archive(arguments.archive, Archive::Access::existing);
  const std::string site = siteToAddTo(arguments, archive);
  merge.files = recordFiles(archive, site, arguments.most);
  merge.known = archive.history(site).ledger;
  if (merge.files.size() < 2)
    throw DataError(arguments.archive + ": has less than two runs of " + site +
                    " whose files are there: add some");
  return mergeSite(merge);
}

int list(const ArchiveArguments& arguments) {
  for (const WatchedSite& site : sitesToTell(arguments)) {
    print(printable(site.history.site) + ":\n");
    for (const HistoryRun& run : site.history.runs) {
      const auto error = trustedValueOf(run.figures, kMapError);
      const std::string figure = error ? formatted("%7.3f m", *error) : "      -  ";
      print("  " + timeText(run.time) + " " + figure + "  " + printable(run.robot) + "  " +
            printable(run.file) + (run.isPlaced ? "" : "  (another site)") + "\n");
    }
  }
  return kDone;
}

int listRooms(const ArchiveArguments& arguments) {
  for (const WatchedSite& site : sitesToTell(arguments)) {
    print(printable(site.history.site) + ":\n");
    for (const SiteRoom& room : site.history.ledger.rooms)
      print("  " + room.id + (room.name == room.id ? "" : "  " + printable(room.name)) +
            (room.isCorridor ? "  (corridor)" : "") + "\n");
  }
  return kDone;
}

/** @throws UsageError where it is no name. */
void checkName(const ArchiveArguments& arguments) {
  if (printable(arguments.name) != arguments.name || arguments.name.empty())
    throw UsageError("NAME: is empty or no text of one line: choose another name");
}

int removeRun(const ArchiveArguments& arguments) {
  Archive archive(arguments.archive, Archive::Access::existing);
  archive.removeRun(siteToAddTo(arguments, archive), arguments.run);
  return kDone;
}

int renameRobot(const ArchiveArguments& arguments) {
  checkName(arguments);
  Archive archive(arguments.archive, Archive::Access::existing);
  archive.renameRobot(siteToAddTo(arguments, archive), arguments.robot, arguments.name);
  return kDone;
}

int nameRoom(const ArchiveArguments& arguments) {
  checkName(arguments);
  Archive archive(arguments.archive, Archive::Access::existing);
  archive.nameRoom(siteToAddTo(arguments, archive), arguments.room, arguments.name);
  return kDone;
}

/** Throws where the file for what is told would take the place of what is not to be replaced. */
void checkOutput(const std::string& file, const std::vector<WatchedSite>& sites,
                 const ArchiveArguments& arguments) {
  CallFiles files;
  files.reads(arguments.archive);
  for (const WatchedSite& site : sites)
    for (const HistoryRun& run : site.history.runs) files.reads(run.file);
  files.writesTo("--output", file);
}

/** One line on stderr for each robot whose maps are not as they should be; whether there is one.
 */
bool tellFaults(const std::vector<WatchedSite>& sites, const ArchiveArguments& arguments) {
  const bool isAsked = arguments.failsOnAlarm || arguments.failsOnLatest;
  bool isAnyWrong = isAsked && sites.empty();
  if (isAnyWrong) printError(arguments.archive + ": has no runs, so none can be judged");
  for (const WatchedSite& site : sites) {
    if (isAsked && site.history.runs.empty()) {
      printError(printable(site.history.site) + ": has no runs, so none can be judged");
      isAnyWrong = true;
    }
    for (const RobotWatch& robot : site.watch.robots) {
      const bool isAlarm = arguments.failsOnAlarm && robot.isAlarm();
      const bool isKept = arguments.failsOnLatest && robot.rollout == Rollout::no;
      if (!isAlarm && !isKept) continue;
      const std::string text = (isKept ? robot.advice : "") + (isKept && isAlarm ? "; " : "") +
                               (isAlarm ? robot.sentence : "");
      printError(printable(site.history.site) + ": " + printable(robot.robot) + ": " +
                 printable(text));
      isAnyWrong = true;
    }
  }
  return isAnyWrong;
}

int report(const ArchiveArguments& arguments) {
  const std::vector<WatchedSite> sites = sitesToTell(arguments);
  checkOutput(arguments.page, sites, arguments);
  if (!arguments.running.isQuiet)
    for (const WatchedSite& site : sites) print(historyText(site));
  if (!arguments.page.empty())
    writeFileAtomically(arguments.page, historyPage(sites, arguments.watch));
  return tellFaults(sites, arguments) ? kGateFailed : kDone;
}

int exportAll(const ArchiveArguments& arguments) {
  const std::vector<WatchedSite> sites = sitesToTell(arguments);
  checkOutput(arguments.output, sites, arguments);
  const std::string text = arguments.format == "csv"    ? historyCsv(sites)
                           : arguments.format == "json" ? historyJson(sites)
                                                        : historyPrometheus(sites);
  if (arguments.output.empty())
    print(text);
  else
    writeFileAtomically(arguments.output, text);
  return kDone;
}

struct ArchiveCommand {
  const char *name, *sentence;
  void (*declare)(ArchiveArguments& arguments, CLI::App& app);
  int (*run)(const ArchiveArguments& arguments);
};

constexpr ArchiveCommand kArchiveCommands[] = {
    {"add", "Compare runs with some of those in the archive, and keep the results.", declareAdd,
     addToArchive},
    {"report",
     "Tell whether the latest maps may be rolled out, whether maps get worse, and which rooms have "
     "changed.",
     declareReport, report},
    {"merge", "Make one map of the runs, as 'roomgraph merge' does.", declareMerge, mergeRunsOf},
    {"list", "List the runs.", declareSite, list},
    {"rooms", "List the rooms with their ids and names.", declareSite, listRooms},
    {"name", "Give a room a name, which it keeps.", declareNaming, nameRoom},
    {"remove", "Take a run out, with its figures; its file stays.", declareRemoving, removeRun},
    {"rename", "Give the runs of a robot another name.", declareRenaming, renameRobot},
    {"export", "Write all that is known, for other programs.", declareExport, exportAll},
};

}  // namespace

std::function<int()> archiveCommand(CLI::App& app) {
  const auto arguments = std::make_shared<ArchiveArguments>();
  addArgument(app, "ARCHIVE", arguments->archive,
              "File of the archive (SQLite); 'add' creates it if missing.");
  app.require_subcommand(1);
  const auto chosen = std::make_shared<const ArchiveCommand*>(nullptr);
  for (const ArchiveCommand& command : kArchiveCommands) {
    CLI::App* sub = app.add_subcommand(command.name, command.sentence);
    command.declare(*arguments, *sub);
    sub->final_callback([chosen, &command] { *chosen = &command; });
  }
  return [arguments, chosen] { return (*chosen)->run(*arguments); };
}

}  // namespace roomgraph
