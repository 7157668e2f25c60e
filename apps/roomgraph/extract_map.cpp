#include "extract_map.h"

#include <filesystem>

#include "Laps.h"
#include "note_lines.h"
#include "output_names.h"
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
    for (const OutputFormat& format : task_.formats) {
      contents.push_back(format.bytes(stages, {}));
      lap(format.name);
    }
    if (!task_.stagesFolder.empty()) {
      const auto folder = std::filesystem::path(task_.stagesFolder) / mapStem(mapFile_);
      drawStages(stages, folder.string(), staged);
      files_.push_back(folder.string() + "/");
      lap("stages");
    }
    for (std::size_t i = 0; i < contents.size(); ++i) {
      const std::string file = outputFile(task_.folder, mapFile_, task_.formats[i].extension);
      staged.add(file, contents[i]);
      files_.push_back(file);
    }
    staged.commit();
    lap("write_files");
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
