#include "ArchiveArguments.h"

#include "commands.h"

namespace roomgraph {

void declareSite(ArchiveArguments& arguments, CLI::App& app) {
  addOption(app, "--site NAME", arguments.site,
            "The site, if the archive has several. The first site is named after the archive.");
}

void declareWatch(ArchiveArguments& arguments, CLI::App& app) {
  addOption(app, "--limit M", arguments.watch.limit,
            "The largest map error that is good enough [m]; three of five nights above it are "
            "an alarm.")
      ->check(CLI::Range(0.001, 1000.0))
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
  declareThreads(arguments.threads, "maps or pairs", app);
  declareConfig(arguments.options, app);
  declareReading(arguments.options, app);
}

}  // namespace roomgraph
