#include <memory>

#include "commands.h"
#include "extract_map.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/map_files/map_formats.h"

namespace roomgraph {
namespace {

struct ExtractArguments {
  std::vector<std::string> maps;
  OptionArguments options;
  std::string folder;
  std::string formats = defaultFormats();
  std::string stagesFolder;
  RunningArguments running;
};

void declareResults(ExtractArguments& arguments, CLI::App& app) {
  declareOutput(arguments.folder, "X.json and the other formats", app);
  addOption(app, "--format LIST", arguments.formats,
            "What to write, as a comma-separated list: " + formatNames() +
                ". The areas of the map (labels, osm, osm_ids) are written only on request.")
      ->capture_default_str();
  addOption(app, "--stages DIR", arguments.stagesFolder,
            "Also draw every step of the extraction, into DIR/X.");
}

int run(const ExtractArguments& arguments) {
  ExtractTask task;
  task.options = toOptions(arguments.options);
  task.formats = parseFormats(arguments.formats);
  task.folder = arguments.folder;
  task.stagesFolder = arguments.stagesFolder;
  task.running = arguments.running;

  std::vector<std::string> extensions;
  for (const OutputFormat& format : task.formats) extensions.push_back(format.extension);
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
