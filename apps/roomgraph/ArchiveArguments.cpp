#include "ArchiveArguments.h"

namespace roomgraph {

void declareSite(ArchiveArguments& arguments, CLI::App& app) {
  app.add_option("--site", arguments.site,
                 "The site, if the archive has several. The first site is named after the archive.")
      ->type_name("NAME");
}

void declareWatch(ArchiveArguments& arguments, CLI::App& app) {
  app.add_option("--limit", arguments.watch.limit,
                 "The largest map error that is good enough [m]; three of five nights above it are "
                 "an alarm.")
      ->type_name("M")
      ->check(CLI::Range(0.001, 1000.0))
      ->capture_default_str();
}

void declareAdding(ArchiveArguments& arguments, CLI::App& app) {
  declareSite(arguments, app);
  app.add_option("--robot", arguments.robot, "The robot that made the runs.")
      ->type_name("NAME")
      ->capture_default_str();
  app.add_option("--compare-with", arguments.most,
                 "How many runs of the archive each is compared with (2 to 100): half of them the "
                 "latest, the others the best.")
      ->type_name("N")
      ->check(CLI::Range(2, 100))
      ->capture_default_str();
  app.add_option("--keep", arguments.kept,
                 "Folder for copies of the maps, in case the next night overwrites the file: later "
                 "runs are compared with the copies.")
      ->type_name("DIR");
  app.add_option(
         "--cache", arguments.cache,
         "Folder that keeps what was found for each pair of maps, as for 'roomgraph compare'.")
      ->type_name("DIR");
  declareThreads(arguments.threads, "maps or pairs", app);
  declareConfig(arguments.options, app);
  declareReading(arguments.options, app);
}

}  // namespace roomgraph
