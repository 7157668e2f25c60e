#include "graph_bytes.h"

#include "byte_writer.h"
#include "roomgraph/graph_files/graph_json.h"
#include "roomgraph/graph_files/read_graph_json.h"

namespace roomgraph {
namespace {

const char* const kGraphRemedy = "make the room graph again from its map";

// Runs of equal cells: maps are mostly large areas, and gzip does the rest.
void putCells(ByteWriter& out, const std::vector<State>& cells) {
  std::vector<std::pair<State, std::uint32_t>> runs;
  for (const State state : cells) {
    if (runs.empty() || runs.back().first != state) runs.emplace_back(state, 0);
    ++runs.back().second;
  }
  out.putCount(runs.size());
  for (const auto& [state, length] : runs) {
    out.put(static_cast<std::uint8_t>(state));
    out.put(length);
  }
}

std::vector<State> readCells(ByteReader& reader, std::size_t needed) {
  constexpr std::size_t runSize = 5;
  const auto runs = reader.get<std::uint32_t>();
  if (runs > reader.left() / runSize)
    refuse(reader.file(), "it claims more data than it holds", kGraphRemedy);
  const ByteView bytes{reader.take(runs * runSize), runs * runSize};
  // Once to check, once to fill: no memory is taken for a map that does not fit.
  std::uint64_t count = 0;
  for (ByteReader run(bytes, reader.file()); run.left() > 0;) {
    if (run.get<std::uint8_t>() > static_cast<std::uint8_t>(State::occupied))
      refuse(reader.file(), "its map has cells of an unknown state", kGraphRemedy);
    count += run.get<std::uint32_t>();
  }
  if (count != needed) refuse(reader.file(), "its map has too many or too few cells", kGraphRemedy);
  std::vector<State> cells;
  cells.reserve(needed);
  for (ByteReader run(bytes, reader.file()); run.left() > 0;) {
    const auto state = static_cast<State>(run.get<std::uint8_t>());
    cells.insert(cells.end(), run.get<std::uint32_t>(), state);
  }
  return cells;
}

}  // namespace

void checkMapSize(const MappedGraph& graph) {
  const std::size_t needed = graph.file.input.frame.cellCount();
  if (graph.map && graph.map->cells.size() != needed)
    throw UsageError("a room graph's map has " + std::to_string(graph.map->cells.size()) +
                     " cells: its frame calls for " + std::to_string(needed));
}

std::string graphBytes(const MappedGraph& graph) {
  checkMapSize(graph);
  ByteWriter out;
  out.putText(graphJson(graph.file));
  out.put(std::uint8_t(graph.map.has_value()));
  if (graph.map) putCells(out, graph.map->cells);
  return std::move(out).take();
}

void readGraphBytes(ByteView bytes, const std::string& name, MappedGraph& graph) {
  ByteReader reader(bytes, name);
  MappedGraph found;
  found.file = parseGraphJson(reader.getText(), name);
  const GridFrame& frame = found.file.input.frame;
  if (frame.cellCount() > kMostCells)
    refuse(name,
           "its map cannot have " + std::to_string(frame.width) + " x " +
               std::to_string(frame.height) + " cells",
           kGraphRemedy);
  if (reader.getFlag()) found.map = Grid{frame, readCells(reader, frame.cellCount())};
  if (reader.left() > 0) refuse(name, "something follows the room graph in it", kGraphRemedy);
  graph = std::move(found);
}

}  // namespace roomgraph
