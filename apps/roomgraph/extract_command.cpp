#include <memory>
#include <optional>

#include "Laps.h"
#include "ResultFolder.h"
#include "commands.h"
#include "option_arguments.h"
#include "output_formats.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/drawing/draw_stages.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/pipeline/extract.h"
#include "run_in_order.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct ExtractArguments {
  std::vector<std::string> maps;
  OptionArguments options;
  std::string folder;  ///< for the results
  std::string formats = defaultFormats();
  std::vector<std::string> keptOut;
  std::string stagesFolder;  ///< for the pictures of the steps; empty for none
  RunningArguments running;
};

/** What to do with each map. */
struct ExtractTask {
  const ExtractArguments& arguments;
  ExtractOptions options;
  std::vector<OutputFormat> formats;
  std::vector<RoomId> keptOut;  ///< of the format keepout
  UnusedOptions& unused;
};

/** Where the steps of a map are drawn. */
std::string stagesOf(const std::string& mapFile, const ExtractArguments& arguments) {
  return inFolder(arguments.stagesFolder, mapStem(mapFile));
}

std::string summaryLine(const std::string& mapFile, const RoomGraph& result) {
  return printable(mapFile) + ": " + counted(result.rooms.size(), "room", "rooms") + ", " +
         counted(result.graph.vertices().size(), "vertex", "vertices") + ", " +
         counted(result.graph.edges().size(), "edge", "edges") + "\n";
}

std::string verboseLine(const std::string& mapFile, const Stages& stages) {
  const GridFrame& frame = stages.grid.frame;
  return errorLine(mapFile + ": " + stages.source.kind +
                   formatted(", %d x %d cells of %g m, lower left corner (%g, %g), paths keep "
                             "%g m clear, %zu pieces of clutter do not split rooms",
                             frame.width, frame.height, frame.resolution, frame.origin.x,
                             frame.origin.y, stages.clearance, stages.cleared.clutter.size()));
}

/** Whether maps of this kind are made of scans, by which their quality can be estimated. */
bool isMadeOfScans(const std::string& kind) {
  const std::vector<MapFormat>& formats = mapFormats();
  return anyOf(formats, [&](const MapFormat& format) {
    return format.kind == kind && format.readRecording;
  });
}

/** One map on its way from file to files: all of them, or none where the map or a drawing fails. */
class Extraction {
 public:
  Extraction(const std::string& mapFile, const ExtractTask& task, JobReport& report)
      : mapFile_(mapFile), task_(task), arguments_(task.arguments), report_(report) {}

  void run() {
    GreyMap map = loadGrid(mapFile_, task_.options.loadGrid);
    lap("load_grid");
    // Only the pictures of the steps show the diagram.
    const Stages stages = arguments_.stagesFolder.empty()
                              ? extractGraph(std::move(map), task_.options)
                              : extract(map, task_.options);
    laps_.end(stages.timings);
    report_.stepDone();
    writeResults(stages);
    describe(stages);
  }

 private:
  void lap(const std::string& stage) {
    laps_.end(stage);
    report_.stepDone();
  }

  void writeResults(const Stages& stages) {
    StagedFiles staged;
    std::vector<std::string> contents;
    checkKeptOut(stages.result);
    for (const OutputFormat& format : task_.formats) {
      contents.push_back(format.bytes(stages, {{}, task_.keptOut}));
      lap(format.name);
    }
    if (!arguments_.stagesFolder.empty()) {
      const std::string folder = stagesOf(mapFile_, arguments_);
      drawStages(stages, folder, staged);
      files_.push_back(folder + "/");
      lap("stages");
    }
    const auto add = [&](const std::string& extension, const std::string& bytes) {
      files_.push_back(outputFile(arguments_.folder, mapFile_, extension));
      staged.add(files_.back(), bytes);
      return fileName(files_.back());
    };
    for (std::size_t i = 0; i < contents.size(); ++i) {
      const OutputFormat& format = task_.formats[i];
      const std::string name = add(format.extension, contents[i]);
      if (format.map)
        add(format.yamlExtension(), rosMapYaml(stages.grid.frame, name, {}, *format.map));
    }
    staged.commit();
    laps_.end("write_files");
  }

  void checkKeptOut(const RoomGraph& graph) const {
    for (const RoomId room : task_.keptOut)
      if (room.index() >= graph.rooms.size())
        throw DataError(
            formatted("%s: there is no room R%zu to keep robots out of: %zu rooms are numbered "
                      "from R0 on",
                      mapFile_.c_str(), room.index(), graph.rooms.size()));
  }

  /** Which rooms robots must not enter. */
  std::string keptOutLines(const RoomGraph& graph) const {
    std::string lines;
    for (const RoomId id : task_.keptOut) {
      const GraphRoom& room = graph.rooms[id.index()];
      lines += formatted("  keeps robots out of R%zu: %.1f m2 at (%.2f, %.2f)\n", id.index(),
                         area(room.shape.polygon), room.center.x, room.center.y);
    }
    return lines;
  }

  void describe(const Stages& stages) {
    if (arguments_.running.showsTimings) report_.err += laps_.table(mapFile_);
    std::vector<MapNote> notes;
    for (const Note& note : stages.notes)
      if (!task_.unused.take(note)) notes.push_back({mapFile_, note});
    if (arguments_.running.isVerbose) report_.err += verboseLine(mapFile_, stages);
    report_.err += noteLines(notes, arguments_.running);
    if (arguments_.running.isQuiet) return;
    report_.out += summaryLine(mapFile_, stages.result);
    report_.out += keptOutLines(stages.result) + fileLines(files_);
    if (isMadeOfScans(stages.source.kind))
      report_.out += "To see how good this run is: roomgraph check '" + printable(mapFile_) + "'\n";
  }

  const std::string& mapFile_;
  const ExtractTask& task_;
  const ExtractArguments& arguments_;
  JobReport& report_;
  std::vector<std::string> files_;
  Laps laps_;
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
            "Repeat it for more: --keep-out R3 --keep-out R4.")
      ->allow_extra_args(false);
  addOption(app, "--stages DIR", arguments.stagesFolder,
            "Also draw every step of the extraction, into DIR/X.");
}

/** The rooms that are named as X.json and X.svg number them. */
std::vector<RoomId> keptOutRooms(const ExtractArguments& arguments,
                                 const std::vector<OutputFormat>& formats) {
  std::vector<RoomId> rooms;
  for (const std::string& name : arguments.keptOut) {
    std::size_t number = 0;
    if (name.rfind('R', 0) != 0 || !parseNumber(name.substr(1), number))
      throw UsageError("extract: --keep-out " + name +
                       ": is no room: give one as X.json numbers it, such as R3, and repeat the "
                       "option for more");
    rooms.emplace_back(number);
  }
  if (!rooms.empty() && !anyOf(formats, [](const OutputFormat& format) {
        return format.name == std::string("keepout");
      }))
    throw UsageError("extract: --keep-out is for the format keepout: add it to --format");
  return rooms;
}

int run(const ExtractArguments& arguments) {
  UnusedOptions unused;
  ExtractTask task{
      arguments, toOptions(arguments.options), parseFormats(arguments.formats), {}, unused};
  task.keptOut = keptOutRooms(arguments, task.formats);
  std::vector<std::string> extensions;
  for (const OutputFormat& format : task.formats) {
    extensions.push_back(format.extension);
    if (format.map) extensions.push_back(format.yamlExtension());
  }
  CallFiles files = filesReadBy(arguments.maps, arguments.options);
  files.writesOfEach(arguments.maps, arguments.folder, extensions);
  if (!arguments.stagesFolder.empty())
    for (const std::string& map : arguments.maps)
      for (const std::string& name : stageFiles())
        files.writes(inFolder(stagesOf(map, arguments), name), map);
  const ResultFolder folder(arguments.folder);
  std::optional<ResultFolder> stages;
  if (!arguments.stagesFolder.empty()) stages.emplace(arguments.stagesFolder);

  const std::vector<std::string>& maps = arguments.maps;
  const auto extractOne = [&](std::size_t index, JobReport& report) {
    Extraction(maps[index], task, report).run();
  };
  const JobList jobs{maps.size(), extractOne, [&](std::size_t index) { return maps[index]; },
                     task.formats.size() + (arguments.stagesFolder.empty() ? 3 : 4)};
  const int exitCode = runInOrder(jobs, arguments.running.threads, !arguments.running.isQuiet);
  unused.tell(arguments.maps.size());
  return exitCode;
}

}  // namespace

std::function<int()> extractCommand(CLI::App& app) {
  const auto arguments = std::make_shared<ExtractArguments>();
  addArgument(app, "MAP", arguments->maps,
              "Maps to read, each an " + mapFormatsText() +
                  ", compressed or not. The content tells the kind. Several maps are "
                  "processed in parallel.");
  declareResults(*arguments, app);
  declareOptions(arguments->options, app);
  declareRooms(arguments->options, app);
  declareRunning(arguments->running, "maps", "how each map was read", app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
