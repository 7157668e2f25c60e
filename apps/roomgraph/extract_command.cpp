#include <algorithm>
#include <memory>

#include "commands.h"
#include "extract_map.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/map_files/map_formats.h"

namespace roomgraph {
namespace {

struct ExtractArguments {
  std::vector<std::string> maps;
  OptionArguments options;
  std::string folder;
  std::string formats = defaultFormats();
  std::vector<std::string> keptOut;
  std::string stagesFolder;
  RunningArguments running;
};

void declareResults(ExtractArguments& arguments, CLI::App& app) {
  declareOutput(arguments.folder, "X.json and the other formats", app);
  addOption(app, "--format LIST", arguments.formats,
            "What to write, as a comma-separated list: " + formatNames() +
                ". The areas of the map (labels, osm, osm_ids) and masks for nav2 (keepout, speed) "
                "are written only on request.")
      ->capture_default_str();
  addOption(app, "--keep-out ROOM", arguments.keptOut,
            "A room that robots must not enter, as X.json numbers it (R3), for the format keepout. "
            "May be repeated.")
      ->allow_extra_args(false);
  addOption(app, "--stages DIR", arguments.stagesFolder,
            "Also draw every step of the extraction, into DIR/X.");
}

/** The rooms that are named as X.json and X.svg number them. */
std::vector<RoomId> keptOutRooms(const ExtractArguments& arguments,
                                 const std::vector<OutputFormat>& formats) {
  std::vector<RoomId> rooms;
  for (const std::string& name : arguments.keptOut) {
    const auto number = numberAfter('R', name);
    if (!number)
      throw UsageError("extract: --keep-out " + name +
                       ": is no room: name one as X.json has it, R3");
    rooms.emplace_back(*number);
  }
  if (!rooms.empty() &&
      std::none_of(formats.begin(), formats.end(), [](const OutputFormat& format) {
        return format.name == std::string("keepout");
      }))
    throw UsageError("extract: --keep-out is for the format keepout: add it to --format");
  return rooms;
}

int run(const ExtractArguments& arguments) {
  ExtractTask task;
  task.options = toOptions(arguments.options);
  task.formats = parseFormats(arguments.formats);
  task.keptOut = keptOutRooms(arguments, task.formats);
  task.folder = arguments.folder;
  task.stagesFolder = arguments.stagesFolder;
  task.running = arguments.running;

  std::vector<std::string> extensions;
  for (const OutputFormat& format : task.formats) {
    extensions.push_back(format.extension);
    if (format.map) extensions.push_back(format.yamlExtension());
  }
  checkOutputNames(arguments.maps, task.folder, extensions);
  makeWritableFolder(task.folder);
  if (!task.stagesFolder.empty()) makeWritableFolder(task.stagesFolder);

  JobList jobs;
  jobs.count = arguments.maps.size();
  jobs.stepsPerJob = stepCount(task);
  jobs.run = [&](std::size_t index, const std::function<void()>& stepDone) {
    return extractMap(arguments.maps[index], task, stepDone);
  };
  return runInOrder(jobs, arguments.running.threads, !arguments.running.isQuiet);
}

}  // namespace

std::function<int()> extractCommand(CLI::App& app) {
  const auto arguments = std::make_shared<ExtractArguments>();
  addArgument(app, "MAP", arguments->maps,
              "Maps to read, each an " + mapFormatsText() +
                  ", compressed or not. The kind is told by the content. Several maps are "
                  "processed in parallel.");
  declareResults(*arguments, app);
  declareConfig(arguments->options, app);
  declareReading(arguments->options, app);
  declareRooms(arguments->options, app);
  declareRunning(arguments->running, "maps", "how each map was read", app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
