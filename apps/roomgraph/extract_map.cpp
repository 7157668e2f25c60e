#include "extract_map.h"

#include <algorithm>
#include <filesystem>

#include "Laps.h"
#include "note_lines.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/drawing/draw_stages.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/pipeline/extract.h"
#include "terminal.h"

namespace roomgraph {
namespace {

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
  return std::any_of(formats.begin(), formats.end(), [&](const MapFormat& format) {
    return format.kind == kind && format.readRecording;
  });
}

/** One map on its way from file to files. */
class Extraction {
 public:
  Extraction(const std::string& mapFile, const ExtractTask& task,
             const std::function<void()>& stepDone)
      : mapFile_(mapFile), task_(task), stepDone_(stepDone) {}

  JobReport run() {
    GreyMap map = loadGrid(mapFile_, task_.options.loadGrid);
    lap("load_grid");
    // Only the pictures of the steps show the diagram.
    const Stages stages = task_.stagesFolder.empty() ? extractGraph(std::move(map), task_.options)
                                                     : extract(map, task_.options);
    laps_.end(stages.timings);
    stepDone_();
    writeResults(stages);
    describe(stages);
    return std::move(report_);
  }

 private:
  void lap(const std::string& stage) {
    laps_.end(stage);
    stepDone_();
  }

  void writeResults(const Stages& stages) {
    StagedFiles staged;
    std::vector<std::string> contents;
    checkKeptOut(stages.result);
    for (const OutputFormat& format : task_.formats) {
      contents.push_back(format.bytes(stages, {{}, task_.keptOut}));
      lap(format.name);
    }
    if (!task_.stagesFolder.empty()) {
      const auto folder = std::filesystem::path(task_.stagesFolder) / mapStem(mapFile_);
      drawStages(stages, folder.string(), staged);
      files_.push_back(folder.string() + "/");
      lap("stages");
    }
    const auto add = [&](const std::string& extension, const std::string& bytes) {
      files_.push_back(outputFile(task_.folder, mapFile_, extension));
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
    lap("write_files");
  }

  void checkKeptOut(const RoomGraph& graph) const {
    for (const RoomId room : task_.keptOut)
      if (room.index() >= graph.rooms.size())
        throw DataError(
            formatted("%s: has no room R%zu to keep robots out of: it has %zu, from R0 "
                      "on",
                      mapFile_.c_str(), room.index(), graph.rooms.size()));
  }

  void describe(const Stages& stages) {
    if (task_.running.showsTimings) report_.err += laps_.table(mapFile_);
    if (task_.running.isQuiet) return;
    if (task_.running.isVerbose) report_.err += verboseLine(mapFile_, stages);
    std::vector<MapNote> notes;
    for (const Note& note : stages.notes) notes.push_back({mapFile_, note});
    report_.err += noteLines(notes, task_.running.isVerbose);
    report_.out += summaryLine(mapFile_, stages.result);
    for (const std::string& file : files_) report_.out += "  " + printable(file) + "\n";
    if (isMadeOfScans(stages.source.kind))
      report_.out += "  'roomgraph check' estimates from its scans how good the map is\n";
  }

  const std::string& mapFile_;
  const ExtractTask& task_;
  const std::function<void()>& stepDone_;
  JobReport report_;
  std::vector<std::string> files_;
  Laps laps_;
};

}  // namespace

std::size_t stepCount(const ExtractTask& task) {
  return task.formats.size() + (task.stagesFolder.empty() ? 3 : 4);
}

JobReport extractMap(const std::string& mapFile, const ExtractTask& task,
                     const std::function<void()>& stepDone) {
  try {
    return Extraction(mapFile, task, stepDone).run();
  } catch (...) {
    const Failure failure = currentFailure(mapFile);
    return {"", failure.line, failure.exitCode};
  }
}

}  // namespace roomgraph
