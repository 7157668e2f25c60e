#include "object_bytes.h"

#include <mrpt/io/CMemoryStream.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "roomgraph/base/compressed.h"
#include "roomgraph/graph_files/graph_json.h"
#include "roomgraph/graph_files/read_graph_json.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/scans/object_header.h"

namespace roomgraph {
namespace {

/** Appends little-endian values, as MRPT streams them and ByteReader reads them. */
class ByteWriter {
 public:
  template <class T>
  void put(T value) {
    static_assert(std::is_arithmetic_v<T>);
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    bytes_.append(bytes, sizeof(T));
  }
  void putCount(std::size_t count) { put(static_cast<std::uint32_t>(count)); }
  void putText(const std::string& text) {
    putCount(text.size());
    bytes_ += text;
  }
  std::string take() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

const char* const kRemedy = "compare the maps again";

std::vector<Point> readWalls(ByteReader& reader) {
  std::vector<Point> walls;
  const auto count = reader.get<std::uint32_t>();
  if (count > reader.left() / (2 * sizeof(float)))
    refuse(reader.file(), "it is cut short or damaged", kRemedy);
  for (std::uint32_t i = 0; i < count; ++i) {
    const float x = reader.get<float>(), y = reader.get<float>();
    if (!std::isfinite(x) || !std::isfinite(y))
      refuse(reader.file(), "a place in it is not a number", kRemedy);
    walls.push_back({double(x), double(y)});
  }
  return walls;
}

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

/** Reads what the stream claims to hold piece by piece: a false claim costs no memory. */
std::string readClaimed(mrpt::serialization::CArchive& reader, std::uint64_t size) {
  constexpr std::uint64_t pieceSize = 1 << 20;
  std::string bytes;
  while (bytes.size() < size) {
    const auto piece = static_cast<std::size_t>(std::min(size - bytes.size(), pieceSize));
    bytes.resize(bytes.size() + piece);
    if (reader.ReadBuffer(bytes.data() + bytes.size() - piece, piece) != piece)
      throw std::runtime_error("end of stream");
  }
  return bytes;
}

}  // namespace

std::string objectBytes(const mrpt::serialization::CSerializable& object) {
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  return {static_cast<const char*>(stream.getRawBufferData()),
          std::size_t(stream.getTotalBytesCount())};
}

std::string gzippedObject(const mrpt::serialization::CSerializable& object) {
  return compressed(objectBytes(object), Compression::gzip);
}

void putBody(mrpt::serialization::CArchive& out, const std::string& bytes) {
  out << static_cast<std::uint64_t>(bytes.size());
  out.WriteBuffer(bytes.data(), bytes.size());
}

void readBody(mrpt::serialization::CArchive& reader, std::uint8_t version, const ObjectKind& kind,
              const std::function<void(ByteView)>& read) {
  if (version > kind.newest)
    refuse(kind.name, "its version " + std::to_string(version) + " is not known",
           "read it with a newer roomgraph");
  std::string bytes;
  try {
    bytes = readClaimed(reader, reader.ReadAs<std::uint64_t>());
  } catch (const std::exception&) {
    // MRPT's own message is a page with a backtrace.
    refuse(kind.name, "it is cut short or damaged", "copy or save it again");
  }
  read(viewOf(bytes));
}

void readObjectFile(const std::string& path, const ObjectKind& kind,
                    const std::function<void(ByteView)>& read) {
  CheckedFile file(path);
  const std::optional<ObjectHeader> head = peekObjectHeader(file.head());
  if (!head || head->className != kind.className)
    refuse(path, std::string("is not a ") + kind.name, kind.remedy);
  ByteReader reader(file.content(), path);
  const ObjectHeader header = readObjectHeader(reader);
  checkVersion(reader, header, kind.newest);
  const auto size = reader.get<std::uint64_t>();
  const ByteView body{reader.take(size), static_cast<std::size_t>(size)};
  readObjectEnd(reader, header);
  if (reader.left() > 0)
    refuse(path, std::string("something follows the ") + kind.name + " in it", "save it again");
  read(body);
}

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

std::string comparisonBytes(const MappedComparison& comparison) {
  ByteWriter out;
  out.putText(comparisonJson(comparison.comparison));
  out.putCount(comparison.walls.size());
  for (const auto& [run, walls] : comparison.walls) {
    out.putText(run);
    out.putCount(walls.size());
    for (const Point wall : walls) {
      out.put(float(wall.x));
      out.put(float(wall.y));
    }
  }
  return std::move(out).take();
}

void readComparisonBytes(ByteView bytes, const std::string& name, MappedComparison& comparison) {
  ByteReader reader(bytes, name);
  comparison.comparison = parseComparisonJson(reader.getText(), name);
  comparison.walls.clear();
  const auto count = reader.get<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string run = reader.getText();
    comparison.walls.emplace(run, readWalls(reader));
  }
  if (reader.left() > 0) refuse(name, "something is left over in it", kRemedy);
}

}  // namespace roomgraph
