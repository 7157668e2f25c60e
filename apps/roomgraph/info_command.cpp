#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "commands.h"
#include "option_arguments.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/read_document.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/graph_files/read_graph_json.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/grid_of_scans.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/read_recording.h"
#include "roomgraph/mrpt_plugin/graph_text.h"
#include "roomgraph/mrpt_plugin/map_comparison_file.h"
#include "roomgraph/mrpt_plugin/room_graph_file.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/scans/place_scans.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct InfoArguments {
  std::vector<std::string> files;
  OptionArguments options;
  bool buildsGrid = false;
};

/** The first bytes of a file, unpacked. */
std::string firstBytes(const std::string& file) {
  constexpr std::size_t kEnough = 64;
  return CheckedFile(file).head().text().substr(0, kEnough);
}

std::string gridText(const GreyMap& map, const ExtractOptions& options) {
  const GridFrame& frame = map.frame;
  std::array<std::size_t, 3> counts{};
  for (const State state : binarize(map, options.binarize).cells) ++counts[std::size_t(state)];
  const double cells = frame.cellCount() > 0 ? double(frame.cellCount()) : 1;
  const auto share = [&](State state) { return 100 * double(counts[std::size_t(state)]) / cells; };
  std::string text = formatted(
      "size        %d x %d cells, %g x %g m\nresolution  %g m\n"
      "origin      (%.10g, %.10g) m\ncells       %.1f %% free, %.1f %% occupied, "
      "%.1f %% unknown\n",
      frame.width, frame.height, frame.width * frame.resolution, frame.height * frame.resolution,
      frame.resolution, frame.origin.x, frame.origin.y, share(State::free), share(State::occupied),
      share(State::unknown));
  if (!map.source.insertion.empty()) text += "insertion   " + map.source.insertion + "\n";
  for (const Note& note : map.notes) text += "note        " + note.text + "\n";
  return text;
}

std::string mapText(const std::string& file, const ExtractOptions& options) {
  const GreyMap map = loadGrid(file, options.loadGrid);
  return "kind        " + map.source.kind + "\nsha256      " + map.source.sha256 + "\n" +
         gridText(map, options);
}

std::string runText(const Recording& run) {
  std::string text = "kind        simplemap\nsha256      " + run.sha256 + "\n";
  text += formatted("key frames  %zu, %zu of them without scans\npath        %.1f m\n",
                    run.frames.size(), run.framesWithoutScans(), run.pathLength());
  if (const auto times = run.times())
    text += formatted("duration    %.1f s, from %.3f s after 1970 (UTC)\n",
                      times->second - times->first, times->first);
  std::map<std::string, std::size_t> sensors;
  for (const auto& [sensor, count] : run.sensors) sensors[sensor.name()] += count;
  for (const auto& [sensor, count] : sensors)
    text += "sensor      " + printable(sensor) + ": " + std::to_string(count) + "\n";
  return text + "version     CSimpleMap " + std::to_string(run.version) + ", compression " +
         nameOf(run.compression) + "\n";
}

/** Of X.json or comparison.json; nothing for JSON that is not of this package. */
std::optional<std::string> jsonText(const std::string& file) {
  const std::string json = readFile(file);
  if (json.find("\"roomgraph/") == std::string::npos) return std::nullopt;
  if (jsonFault(json, "roomgraph/comparison").empty())
    return CMapComparison(parseComparisonJson(json, file), {}).asString();
  return graphText(parseGraphJson(json, file));
}

std::string infoText(const std::string& file, const ExtractOptions& options) {
  const std::string start = firstBytes(file);
  if (firstLetter(start) == '{')
    if (auto text = jsonText(file)) return *std::move(text);
  if (start.find("CRoomGraph") != std::string::npos) return loadRoomGraph(file).asString();
  if (start.find("CMapComparison") != std::string::npos) return loadMapComparison(file).asString();
  return mapText(file, options);
}

int run(const InfoArguments& arguments) {
  const ExtractOptions options = toOptions(arguments.options);
  return doEach(arguments.files, [&](const std::string& file) {
    std::string heading = &file == &arguments.files.front() ? "" : "\n";
    heading += printable(file) + ":\n";
    auto recording = readRecording(file);
    if (!recording) return print(heading + infoText(file, options));
    // What is known of a run is worth telling even where no grid can be built from it.
    print(heading + runText(*recording));
    if (!arguments.buildsGrid) return;
    const PlacedScans scans = placeScans(std::move(*recording), options.loadGrid);
    print(gridText(gridOfScans(scans, options.loadGrid), options));
  });
}

}  // namespace

std::function<int()> infoCommand(CLI::App& app) {
  const auto arguments = std::make_shared<InfoArguments>();
  addArgument(app, "FILE", arguments->files,
              "Maps as for 'roomgraph extract', or results: X.json, X.roomgraph, comparison.json, "
              "comparison.roomgraph.");
  app.add_flag("--grid", arguments->buildsGrid,
               "Also build the grid of each simplemap, and tell what it holds.");
  declareOptions(arguments->options, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
