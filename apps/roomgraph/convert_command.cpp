#include <memory>

#include "ResultFolder.h"
#include "commands.h"
#include "option_arguments.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/mrpt_plugin/mrpt_files.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct ConvertArguments {
  std::vector<std::string> maps;
  OptionArguments options;
  std::string folder = ".", format = "ros";
};

/** A kind of file that maps are written as. */
struct MapOutput {
  const char* name;
  std::vector<std::string> extensions;
  /** The bytes of each file, in the order of the extensions; X is their common name. */
  std::vector<std::string> (*bytes)(const GreyMap& map, const Grid& grid, const std::string& x);
};

const std::vector<MapOutput>& outputs() {
  static const std::vector<MapOutput> all = {
      {"ros",
       {"yaml", "pgm"},
       [](const GreyMap&, const Grid& grid, const std::string& x) {
         return std::vector<std::string>{rosMapYaml(grid.frame, x + ".pgm"), mapPgm(grid)};
       }},
      {"gridmap",
       {"gridmap"},
       [](const GreyMap& map, const Grid& grid, const std::string&) {
         return std::vector<std::string>{gridmapBytes(map, grid)};
       }},
      {"png",
       {"png"},
       [](const GreyMap&, const Grid& grid, const std::string&) {
         return std::vector<std::string>{mapPng(grid)};
       }},
  };
  return all;
}

const MapOutput& outputNamed(const std::string& name) {
  for (const MapOutput& output : outputs())
    if (name == output.name) return output;
  throw UsageError("there is no format '" + name + "': --format takes ros, gridmap or png");
}

/** Prints the notes of the map and the names of what is written. */
void convert(const std::string& file, const MapOutput& output, const ExtractOptions& options,
             const std::string& folder, UnusedOptions& unused) {
  const GreyMap map = loadGrid(file, options.loadGrid);
  const auto contents = output.bytes(map, binarize(map, options.binarize), mapStem(file));
  FolderFiles files{folder};
  for (std::size_t i = 0; i < contents.size(); ++i)
    files.add(mapStem(file) + "." + output.extensions[i], contents[i]);
  files.staged.commit();
  for (const Note& note : map.notes)
    if (!unused.take(note)) printError(file + ": note: " + note.text);
  for (const std::string& name : files.names) print(printable(name) + "\n");
}

int run(const ConvertArguments& arguments) {
  const ExtractOptions options = toOptions(arguments.options);
  const MapOutput& output = outputNamed(arguments.format);
  filesReadBy(arguments.maps, arguments.options)
      .writesOfEach(arguments.maps, arguments.folder, output.extensions);
  const ResultFolder folder(arguments.folder);
  UnusedOptions unused;
  const int exitCode = doEach(arguments.maps, [&](const std::string& file) {
    convert(file, output, options, arguments.folder, unused);
  });
  unused.tell(arguments.maps.size());
  return exitCode;
}

}  // namespace

std::function<int()> convertCommand(CLI::App& app) {
  const auto arguments = std::make_shared<ConvertArguments>();
  addArgument(app, "MAP", arguments->maps, "Maps as for 'roomgraph extract'.");
  addOption(app, "-o,--output DIR", arguments->folder, "Folder for the maps; created if missing.")
      ->capture_default_str();
  addOption(app, "--format NAME", arguments->format,
            "What to write: 'ros' (X.yaml and X.pgm, for ROS's map_server), 'gridmap' (for "
            "MRPT) or 'png' (a picture).")
      ->capture_default_str();
  declareOptions(arguments->options, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
