#include <memory>

#include "commands.h"
#include "merge_site.h"

namespace roomgraph {

std::function<int()> mergeCommand(CLI::App& app) {
  const auto arguments = std::make_shared<MergeArguments>();
  addArgument(app, "RUN", arguments->site.files, "Simplemaps of one site, each of a drive.");
  addOption(app, "--names FILE", arguments->names,
            "JSON file that keeps the ids and names of the site's rooms, as for 'roomgraph "
            "compare': the graph has them.");
  declareMerging(*arguments, app);
  return [arguments] { return mergeSite(*arguments); };
}

}  // namespace roomgraph
