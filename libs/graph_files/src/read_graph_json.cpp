#include "roomgraph/graph_files/read_graph_json.h"

#include <limits>

#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/Json.h"
#include "roomgraph/base/read_document.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/point_json.h"
#include "roomgraph/rooms/reason_names.h"
#include "roomgraph/topology/kind_names.h"

namespace roomgraph {
namespace {

/** Things that each carry their place in the list as their id. */
template <class Read>
auto readNumbered(const std::vector<JsonNode>& nodes, const Read& read) {
  std::size_t place = 0;
  return mapped(nodes, [&](const JsonNode& node) {
    node.checkId(place++);
    return read(node);
  });
}

template <class ThingId>
std::vector<ThingId> readIds(const JsonNode& node, std::size_t size) {
  return mapped(node.list(), [&](const JsonNode& one) { return readId<ThingId>(one, size); });
}

GraphFile::Input readInput(const JsonNode& node) {
  GraphFile::Input input;
  input.file = node["file"].text();
  input.kind = node["kind"].text();
  input.sha256 = node["sha256"].text();
  if (node.contains("insertion")) input.insertion = node["insertion"].text();
  constexpr std::size_t kMaxCells = std::numeric_limits<int>::max();
  const auto size = node["size"].list();
  if (size.size() != 2) throw Broken{node.place + ".size", "is not a pair [width, height]"};
  input.frame.width = int(size[0].countBelow(kMaxCells));
  input.frame.height = int(size[1].countBelow(kMaxCells));
  input.frame.resolution = node["resolution"].number();
  input.frame.origin = readPoint(node["origin"]);
  return input;
}

SavedOption readOption(const std::string& section, const std::string& key, const Json& value) {
  SavedOption option{section, key, {}};
  if (value.is_boolean())
    option.value = value.get<bool>();
  else if (value.is_number_integer() && value == value.get<int>())
    option.value = value.get<int>();
  else if (value.is_number())
    option.value = value.get<double>();
  else if (value.is_string())
    option.value = value.get<std::string>();
  else
    throw Broken{"options." + section + "." + key, "is not a number, switch or text"};
  return option;
}

std::vector<SavedOption> readOptions(const JsonNode& node) {
  std::vector<SavedOption> options;
  if (!node.json.is_object()) throw Broken{node.place, "is not an object"};
  for (const auto& [section, values] : node.json.items()) {
    if (!values.is_object()) throw Broken{node.place + "." + section, "is not an object"};
    for (const auto& [key, value] : values.items())
      options.push_back(readOption(section, key, value));
  }
  return options;
}

Vertex readVertex(const JsonNode& node, std::size_t roomCount) {
  const auto kind = valueOfName<VertexKind>(node["kind"].text());
  if (!kind) throw Broken{node.place + ".kind", "is not a kind of vertex"};
  return {{node["x"].number(), node["y"].number()},
          node["clearance"].numberOrInfinity(),
          *kind,
          readIdOrNone<RoomId>(node["room"], roomCount)};
}

Edge readEdge(const JsonNode& node, std::size_t vertexCount, std::size_t roomCount) {
  Edge edge;
  edge.source = readId<VertexId>(node["source"], vertexCount);
  edge.target = readId<VertexId>(node["target"], vertexCount);
  edge.room = readIdOrNone<RoomId>(node["room"], roomCount);
  edge.path.points = readPoints(node["path"]);
  if (edge.path.points.empty()) throw Broken{node.place + ".path", "has no point"};
  edge.path.length = node["length"].number();
  edge.path.minClearance = node["min_clearance"].numberOrInfinity();
  return edge;
}

GraphRoom readRoom(const JsonNode& node, std::size_t vertexCount) {
  GraphRoom room;
  room.shape.polygon = readPolygon(node);
  room.shape.widestPlace = readPoint(node["widest_place"]);
  room.shape.inscribedRadius = node["inscribed_radius"].number();
  room.center = readPoint(node["center"]);
  room.vertex = readIdOrNone<VertexId>(node["vertex"], vertexCount);
  room.borderVertices = readIds<VertexId>(node["border_vertices"], vertexCount);
  return room;
}

RoomGraph readGraph(const JsonNode& top) {
  const auto vertexNodes = top["vertices"].list(), edgeNodes = top["edges"].list(),
             roomNodes = top["rooms"].list();
  const std::size_t vertexCount = vertexNodes.size(), roomCount = roomNodes.size();
  auto vertices =
      readNumbered(vertexNodes, [&](const JsonNode& node) { return readVertex(node, roomCount); });
  auto edges = readNumbered(
      edgeNodes, [&](const JsonNode& node) { return readEdge(node, vertexCount, roomCount); });
  RoomGraph result;
  result.rooms =
      readNumbered(roomNodes, [&](const JsonNode& node) { return readRoom(node, vertexCount); });
  result.graph = TopologyGraph(std::move(vertices), std::move(edges));
  return result;
}

Area readArea(const JsonNode& node, std::size_t roomCount, std::size_t passageCount) {
  Area area;
  area.room = readIdOrNone<RoomId>(node["room"], roomCount);
  if (node["kind"].text() != (area.isRoom() ? "room" : "corridor"))
    throw Broken{node.place + ".kind", "does not fit to its room"};
  area.polygon = readPolygon(node);
  area.widestPlace = readPoint(node["widest_place"]);
  area.inscribedRadius = node["inscribed_radius"].number();
  if (node.contains("seen") && !node["seen"].json.is_null()) area.seen = node["seen"].number();
  area.passages = readIds<PassageId>(node["passages"], passageCount);
  return area;
}

PassageEvidence readEvidence(const JsonNode& node) {
  const auto reason = valueOfName<PassageReason>(node["evidence"].text());
  if (!reason) throw Broken{node.place + ".evidence", "is no evidence of a passage"};
  const double confidence = node["confidence"].number();
  if (confidence < 0 || confidence > 1)
    throw Broken{node.place + ".confidence", "is not between 0 and 1"};
  return {confidence, *reason};
}

Passage readPassage(const JsonNode& node, std::size_t areaCount) {
  const auto areas = node["areas"].list();
  if (areas.size() != 2) throw Broken{node.place + ".areas", "is not a pair [area, area]"};
  const auto ends = readPoints(node["ends"]);
  if (ends.size() != 2) throw Broken{node.place + ".ends", "is not a pair [point, point]"};
  return {readId<AreaId>(areas[0], areaCount),
          readIdOrNone<AreaId>(areas[1], areaCount),
          ends[0],
          ends[1],
          node["width"].number(),
          readEvidence(node)};
}

AreaGraph readAreas(const JsonNode& top, std::size_t roomCount) {
  AreaGraph graph;
  const auto areaNodes = top["areas"].list(), passageNodes = top["passages"].list();
  graph.areas = readNumbered(areaNodes, [&](const JsonNode& node) {
    return readArea(node, roomCount, passageNodes.size());
  });
  graph.passages = readNumbered(
      passageNodes, [&](const JsonNode& node) { return readPassage(node, areaNodes.size()); });
  return graph;
}

Note readNote(const JsonNode& node) {
  Note note{node["code"].text(), node["text"].text(), {}};
  if (!node["x"].json.is_null()) note.where = {node["x"].number(), node["y"].number()};
  return note;
}

GraphFile readTop(const JsonNode& top) {
  if (top["format"].text() != "roomgraph/graph") throw Broken{"format", "is not 'roomgraph/graph'"};
  if (top["version"].json != 1)
    throw Broken{"version", "is not 1, the only one this program reads"};
  GraphFile file;
  file.program = top["program"]["name"].text();
  file.version = top["program"]["version"].text();
  file.input = readInput(top["input"]);
  file.options = readOptions(top["options"]);
  file.graph = readGraph(top);
  file.areas = readAreas(top, file.graph.rooms.size());
  for (const JsonNode& node : top["areas"].list())
    if (node.contains("name")) file.areaNames.push_back(node["name"].text());
  if (!file.areaNames.empty() && file.areaNames.size() != file.areas.areas.size())
    throw Broken{"areas", "have names, but not all of them"};
  file.notes = mapped(top["notes"].list(), readNote);
  return file;
}

}  // namespace

GraphFile parseGraphJson(const std::string& text, const std::string& name) {
  return readDocument(text, name, "roomgraph/graph", "write it anew with 'roomgraph extract'",
                      readTop);
}

GraphFile readGraphJson(const std::string& path) { return parseGraphJson(readFile(path), path); }

}  // namespace roomgraph
