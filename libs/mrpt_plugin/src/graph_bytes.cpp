#include "graph_bytes.h"

#include "byte_writer.h"

namespace roomgraph {
namespace {

template <class Thing>
void putId(ByteWriter& out, Id<Thing> id) {
  out.put(id ? static_cast<std::uint32_t>(id.index()) : kNoId);
}

void putPoint(ByteWriter& out, Point p) {
  out.put(p.x);
  out.put(p.y);
}

void putPoints(ByteWriter& out, const std::vector<Point>& points) {
  out.putCount(points.size());
  for (const Point p : points) putPoint(out, p);
}

void putInput(ByteWriter& out, const GraphFile::Input& input) {
  for (const std::string& text : {input.file, input.kind, input.sha256, input.insertion})
    out.putText(text);
  out.put(static_cast<std::int32_t>(input.frame.width));
  out.put(static_cast<std::int32_t>(input.frame.height));
  out.put(input.frame.resolution);
  putPoint(out, input.frame.origin);
}

void putOptions(ByteWriter& out, const std::vector<SavedOption>& options) {
  out.putCount(options.size());
  for (const SavedOption& option : options) {
    out.putText(option.section);
    out.putText(option.key);
    out.put(static_cast<std::uint8_t>(option.value.index()));
    if (const auto* number = std::get_if<double>(&option.value)) out.put(*number);
    if (const auto* count = std::get_if<int>(&option.value)) out.put(std::int32_t(*count));
    if (const auto* flag = std::get_if<bool>(&option.value)) out.put(std::uint8_t(*flag));
    if (const auto* text = std::get_if<std::string>(&option.value)) out.putText(*text);
  }
}

void putRoom(ByteWriter& out, const GraphRoom& room) {
  putPoints(out, room.shape.polygon.outer);
  out.putCount(room.shape.polygon.holes.size());
  for (const Ring& hole : room.shape.polygon.holes) putPoints(out, hole);
  putPoint(out, room.shape.widestPlace);
  out.put(room.shape.inscribedRadius);
  putPoint(out, room.center);
  putId(out, room.vertex);
  out.putCount(room.borderVertices.size());
  for (const VertexId v : room.borderVertices) putId(out, v);
}

void putVertex(ByteWriter& out, const Vertex& vertex) {
  putPoint(out, vertex.at);
  out.put(vertex.clearance);
  out.put(static_cast<std::uint8_t>(vertex.kind));
  putId(out, vertex.room);
}

void putEdge(ByteWriter& out, const Edge& edge) {
  putId(out, edge.source);
  putId(out, edge.target);
  putId(out, edge.room);
  putPoints(out, edge.path.points);
  putPoints(out, edge.path.obstacles);
  out.put(edge.path.length);
  out.put(edge.path.minClearance);
}

void putNotes(ByteWriter& out, const Notes& notes) {
  out.putCount(notes.size());
  for (const Note& note : notes) {
    out.putText(note.code);
    out.putText(note.text);
    out.put(std::uint8_t(note.where.has_value()));
    if (note.where) putPoint(out, {(*note.where)[0], (*note.where)[1]});
  }
}

// Runs of equal cells: maps are mostly large areas, and gzip does the rest.
void putMap(ByteWriter& out, const std::optional<Grid>& map) {
  out.put(std::uint8_t(map.has_value()));
  if (!map) return;
  std::vector<std::pair<State, std::uint32_t>> runs;
  for (const State state : map->cells) {
    if (runs.empty() || runs.back().first != state) runs.emplace_back(state, 0);
    ++runs.back().second;
  }
  out.putCount(runs.size());
  for (const auto& [state, length] : runs) {
    out.put(static_cast<std::uint8_t>(state));
    out.put(length);
  }
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
  const GraphFile& file = graph.file;
  const TopologyGraph& topology = file.graph.graph;
  ByteWriter out;
  out.putText(file.program);
  out.putText(file.version);
  putInput(out, file.input);
  putOptions(out, file.options);
  out.putCount(file.graph.rooms.size());
  out.putCount(topology.vertices().size());
  out.putCount(topology.edges().size());
  for (const GraphRoom& room : file.graph.rooms) putRoom(out, room);
  for (const Vertex& vertex : topology.vertices()) putVertex(out, vertex);
  for (const Edge& edge : topology.edges()) putEdge(out, edge);
  putNotes(out, file.notes);
  putMap(out, graph.map);
  return std::move(out).take();
}

}  // namespace roomgraph
