#include "ArchiveArguments.h"

#include "commands.h"
#include "roomgraph/archive/SiteHistory.h"
#include "roomgraph/archive/record_files.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/map_sha256.h"
#include "terminal.h"

namespace roomgraph {

std::vector<std::string> recordFiles(const Archive& archive, const std::string& site,
                                     std::size_t most) {
  std::vector<std::string> files;
  const auto onMissing = [](const HistoryRun& run) {
    printError(run.file +
               ": note: is missing or has changed: left out ('archive add --keep' keeps copies)");
  };
  for (const HistoryRun& run : recordRuns(archive.runs(site), most, onMissing))
    if (run.isPlaced) files.push_back(run.file);
  return files;
}

std::string fileOfRun(const Archive& archive, const std::string& site, const std::string& run,
                      const std::string& archiveFile) {
  const std::vector<HistoryRun> runs = archive.runs(site);
  const HistoryRun& meant = namedRun(runs, run, archiveFile);
  if (mapSha256(meant.file) != meant.sha256)
    throw DataError(meant.file + ": is another file now: 'archive add --keep' keeps copies");
  return meant.file;
}

void declareSite(ArchiveArguments& arguments, CLI::App& app) {
  addOption(app, "--site NAME", arguments.site,
            "The site, if the archive has several. The first site is named after the archive.");
}

void declareWatch(ArchiveArguments& arguments, CLI::App& app) {
  addOption(app, "--limit M", arguments.watch.limit,
            "The largest map error that is good enough [m]; three of five nights above it are "
            "an alarm.")
      ->check(isWithin(0.001, 1000))
      ->capture_default_str();
}

void declareAdding(ArchiveArguments& arguments, CLI::App& app) {
  declareSite(arguments, app);
  addOption(app, "--robot NAME", arguments.robot, "The robot that made the runs.")
      ->capture_default_str();
  addOption(app, "--compare-with N", arguments.most,
            "How many runs of the archive each is compared with (2 to 100): half of them the "
            "latest, the others the best.")
      ->check(CLI::Range(2, 100))
      ->capture_default_str();
  addOption(app, "--keep DIR", arguments.kept,
            "Folder for copies of the maps, in case the next night overwrites the file: later "
            "runs are compared with the copies.");
  addOption(app, "--cache DIR", arguments.cache,
            "Folder that keeps what was found for each pair of maps, as for 'roomgraph compare'.");
  declareThreads(arguments.running.threads, "maps or pairs", app);
  declareQuiet(arguments.running.isQuiet, app);
  declareOptions(arguments.options, app);
}

}  // namespace roomgraph
