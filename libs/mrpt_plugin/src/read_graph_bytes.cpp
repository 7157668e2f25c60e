#include <cmath>

#include "graph_bytes.h"

namespace roomgraph {
namespace {

/** Reads the parts of a graph and refuses what cannot be. */
class GraphReader {
 public:
  GraphReader(ByteView bytes, const std::string& name) : in_(bytes, name) {}
  void read(MappedGraph& graph);

 private:
  [[noreturn]] void refuseAs(const std::string& problem) const {
    refuse(in_.file(), problem, "make the room graph again from its map");
  }
  double number() {
    const double value = in_.get<double>();
    if (std::isnan(value)) refuseAs("one of its numbers is not a number");
    return value;
  }
  double finite() {
    const double value = in_.get<double>();
    if (!std::isfinite(value)) refuseAs("one of its coordinates is not finite");
    return value;
  }
  Point point() {
    const double x = finite();
    return {x, finite()};
  }
  /** A count of things that take at least `bytesEach`, so that no list outgrows the file. */
  std::size_t count(std::size_t bytesEach) {
    const std::uint32_t n = in_.get<std::uint32_t>();
    if (n > in_.left() / bytesEach) refuseAs("it claims more data than it holds");
    return n;
  }
  std::string text() {
    const std::size_t n = count(1);
    return {reinterpret_cast<const char*>(in_.take(n)), n};
  }
  template <class AnyId>
  AnyId id(std::size_t size, bool mayBeNone) {
    const std::uint32_t index = in_.get<std::uint32_t>();
    if (index == kNoId && mayBeNone) return AnyId::none();
    if (index >= size) refuseAs("one of its ids names nothing");
    return AnyId(index);
  }
  std::vector<Point> points(std::size_t least) {
    std::vector<Point> all(count(2 * sizeof(double)));
    if (all.size() < least) refuseAs("one of its lines or rings has too few points");
    for (Point& p : all) p = point();
    return all;
  }
  GridFrame frame();
  std::vector<SavedOption> options();
  GraphRoom room();
  Vertex vertex();
  Edge edge();
  Notes notes();
  std::optional<Grid> map(const GridFrame& frame);

  ByteReader in_;
  std::size_t rooms_ = 0, vertices_ = 0;
};

GridFrame GraphReader::frame() {
  GridFrame frame;
  frame.width = in_.get<std::int32_t>();
  frame.height = in_.get<std::int32_t>();
  frame.resolution = finite();
  frame.origin = point();
  if (frame.width < 0 || frame.height < 0 || frame.cellCount() > kMostCells ||
      frame.resolution < 0 || (frame.cellCount() > 0 && frame.resolution == 0))
    refuseAs("its map cannot have " + std::to_string(frame.width) + " x " +
             std::to_string(frame.height) + " cells of that size");
  return frame;
}

std::vector<SavedOption> GraphReader::options() {
  std::vector<SavedOption> options(count(10));
  for (SavedOption& option : options) {
    option.section = text();
    option.key = text();
    switch (in_.get<std::uint8_t>()) {
      case 0:
        option.value = number();
        break;
      case 1:
        option.value = int(in_.get<std::int32_t>());
        break;
      case 2:
        option.value = in_.getFlag();
        break;
      case 3:
        option.value = text();
        break;
      default:
        refuseAs("one of its options is of an unknown type");
    }
  }
  return options;
}

GraphRoom GraphReader::room() {
  GraphRoom room;
  room.shape.polygon.outer = points(3);
  room.shape.polygon.holes.resize(count(4));
  for (Ring& hole : room.shape.polygon.holes) hole = points(3);
  room.shape.widestPlace = point();
  room.shape.inscribedRadius = number();
  room.center = point();
  room.vertex = id<VertexId>(vertices_, false);
  room.borderVertices.resize(count(4));
  for (VertexId& v : room.borderVertices) v = id<VertexId>(vertices_, false);
  return room;
}

Vertex GraphReader::vertex() {
  Vertex vertex;
  vertex.at = point();
  vertex.clearance = number();
  const std::uint8_t kind = in_.get<std::uint8_t>();
  if (kind > static_cast<std::uint8_t>(VertexKind::ring))
    refuseAs("one of its vertices is of an unknown kind");
  vertex.kind = static_cast<VertexKind>(kind);
  vertex.room = id<RoomId>(rooms_, true);
  return vertex;
}

Edge GraphReader::edge() {
  Edge edge;
  edge.source = id<VertexId>(vertices_, false);
  edge.target = id<VertexId>(vertices_, false);
  edge.room = id<RoomId>(rooms_, true);
  edge.path.points = points(2);
  edge.path.obstacles = points(0);
  if (!edge.path.obstacles.empty() && edge.path.obstacles.size() + 1 != edge.path.points.size())
    refuseAs("one of its paths has an obstacle too many or too few");
  edge.path.length = number();
  edge.path.minClearance = number();
  return edge;
}

Notes GraphReader::notes() {
  Notes notes(count(9));
  for (Note& note : notes) {
    note.code = text();
    note.text = text();
    if (!in_.getFlag()) continue;
    const Point at = point();
    note.where = {at.x, at.y};
  }
  return notes;
}

std::optional<Grid> GraphReader::map(const GridFrame& frame) {
  if (!in_.getFlag()) return std::nullopt;
  constexpr std::size_t runSize = 5;
  const std::size_t runs = count(runSize);
  const ByteView bytes{in_.take(runs * runSize), runs * runSize};
  // Once to check, once to fill: no memory is taken for a map that does not fit.
  std::uint64_t cells = 0;
  for (ByteReader run(bytes, in_.file()); run.left() > 0;) {
    if (run.get<std::uint8_t>() > static_cast<std::uint8_t>(State::occupied))
      refuseAs("its map has cells of an unknown state");
    cells += run.get<std::uint32_t>();
  }
  if (cells != frame.cellCount()) refuseAs("its map has too many or too few cells");
  Grid grid{frame, {}};
  grid.cells.reserve(frame.cellCount());
  for (ByteReader run(bytes, in_.file()); run.left() > 0;) {
    const auto state = static_cast<State>(run.get<std::uint8_t>());
    grid.cells.insert(grid.cells.end(), run.get<std::uint32_t>(), state);
  }
  return grid;
}

void GraphReader::read(MappedGraph& graph) {
  GraphFile file;
  file.program = text();
  file.version = text();
  for (std::string* field :
       {&file.input.file, &file.input.kind, &file.input.sha256, &file.input.insertion})
    *field = text();
  file.input.frame = frame();
  file.options = options();
  constexpr std::size_t roomSize = 72, vertexSize = 29, edgeSize = 36;
  rooms_ = count(roomSize);
  vertices_ = count(vertexSize);
  const std::size_t edgeCount = count(edgeSize);
  file.graph.rooms.resize(rooms_);
  for (GraphRoom& each : file.graph.rooms) each = room();
  std::vector<Vertex> vertices(vertices_);
  for (Vertex& each : vertices) each = vertex();
  std::vector<Edge> edges(edgeCount);
  for (Edge& each : edges) each = edge();
  file.graph.graph = TopologyGraph(std::move(vertices), std::move(edges));
  file.notes = notes();
  graph.map = map(file.input.frame);
  graph.file = std::move(file);
  if (in_.left() > 0) refuseAs("something follows the room graph in it");
}

}  // namespace

void readGraphBytes(ByteView bytes, const std::string& name, MappedGraph& graph) {
  GraphReader(bytes, name).read(graph);
}

}  // namespace roomgraph
