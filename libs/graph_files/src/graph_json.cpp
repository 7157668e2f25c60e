#include "roomgraph/graph_files/graph_json.h"

#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/point_json.h"
#include "roomgraph/rooms/reason_names.h"
#include "roomgraph/topology/kind_names.h"

namespace roomgraph {
namespace {

template <class Thing>
Json idOrNull(Id<Thing> id) {
  return id ? Json(id.index()) : Json(nullptr);
}

Json inputJson(const GraphFile::Input& input) {
  const GridFrame& frame = input.frame;
  Json json{{"file", input.file},
            {"sha256", input.sha256},
            {"kind", input.kind},
            {"resolution", frame.resolution},
            {"size", {frame.width, frame.height}},
            {"origin", {frame.origin.x, frame.origin.y}}};
  if (!input.insertion.empty()) json["insertion"] = input.insertion;
  return json;
}

/** The object's text with one more member at its end, which is given as text. */
std::string withMember(std::string object, const char* name, const std::string& value) {
  object.pop_back();
  return object + ",\"" + name + "\":" + value + "}";
}

std::string pointsText(const std::vector<Point>& points) {
  std::string json;
  addPoints(json, points);
  return json;
}

std::string vertexText(std::size_t id, const Vertex& vertex) {
  return lineOf({{"id", id},
                 {"kind", nameOf(vertex.kind)},
                 {"x", rounded(vertex.place.x)},
                 {"y", rounded(vertex.place.y)},
                 {"clearance", rounded(vertex.clearance)},
                 {"room", idOrNull(vertex.room)}});
}

std::string edgeText(const TopologyGraph& graph, std::size_t id, const Edge& edge) {
  const Json json{{"id", id},
                  {"source", edge.source.index()},
                  {"target", edge.target.index()},
                  {"kind", kindName(graph, edge)},
                  {"room", idOrNull(edge.room)},
                  {"length", rounded(edge.path.length)},
                  {"min_clearance", rounded(edge.path.minClearance)}};
  return withMember(lineOf(json), "path", pointsText(edge.path.points));
}

/** As the file has it. */
double roundedArea(const Polygon& polygon) {
  return rounded(area(movedBy(polygon, [](Point p) { return rounded(p); })));
}

/** The object's text with the members "polygon" and "holes" at its end. */
std::string withPolygon(const std::string& object, const Polygon& polygon) {
  std::string holes = "[";
  for (const Ring& hole : polygon.holes) holes += (holes.size() > 1 ? "," : "") + pointsText(hole);
  return withMember(withMember(object, "polygon", pointsText(polygon.outer)), "holes", holes + "]");
}

std::string roomText(std::size_t id, const GraphRoom& room) {
  const Polygon& polygon = room.shape.polygon;
  const Json json{{"id", id},
                  {"vertex", idOrNull(room.vertex)},
                  {"center", pointJson(room.center)},
                  {"area", roundedArea(polygon)},
                  {"inscribed_radius", rounded(room.shape.inscribedRadius)},
                  {"widest_place", pointJson(room.shape.widestPlace)},
                  {"border_vertices", mapped(room.borderVertices, &VertexId::index)}};
  return withPolygon(lineOf(json), polygon);
}

std::string areaText(const std::vector<std::string>& names, std::size_t id, const Area& area) {
  Json json{{"id", id},
            {"kind", area.isRoom() ? "room" : "corridor"},
            {"room", idOrNull(area.room)},
            {"area", roundedArea(area.polygon)},
            {"inscribed_radius", rounded(area.inscribedRadius)},
            {"seen", area.seen ? Json(rounded(*area.seen)) : Json()},
            {"widest_place", pointJson(area.widestPlace)},
            {"passages", mapped(area.passages, &PassageId::index)}};
  if (!names.empty()) json["name"] = names[id];
  return withPolygon(lineOf(json), area.polygon);
}

std::string passageText(std::size_t id, const Passage& passage) {
  const Point from = rounded(passage.from), to = rounded(passage.to);
  Json json{{"id", id},
            {"areas", {idOrNull(passage.a), idOrNull(passage.b)}},
            {"ends", {pointJson(from), pointJson(to)}},
            {"middle", pointJson(midpoint(from, to))},
            {"width", rounded(passage.width)},
            {"confidence", rounded(passage.evidence.confidence)},
            {"evidence", nameOf(passage.evidence.reason)}};
  return lineOf(json);
}

std::string noteText(std::size_t, const Note& note) {
  const auto at = [&](std::size_t axis) {
    return note.where ? Json(rounded((*note.where)[axis])) : Json();
  };
  return lineOf({{"code", note.code}, {"text", note.text}, {"x", at(0)}, {"y", at(1)}});
}

/** The JSON of each thing of a list, by its place and the thing. */
template <class List, class ToText>
void addList(JsonDocument& document, const char* name, const List& list, ToText toText) {
  document.addEntries(name, list.size(), [&](std::size_t i) { return toText(i, list[i]); });
}

/** A line for each section. */
std::string optionsText(const std::vector<SavedOption>& options) {
  Json sections = Json::object();
  for (const SavedOption& option : options)
    std::visit([&](const auto& value) { sections[option.section][option.key] = value; },
               option.value);
  std::string all;
  for (const auto& [section, values] : sections.items())
    all += (all.empty() ? "\n" : ",\n") + lineOf(Json(section)) + ": " + lineOf(values);
  return "{" + all + (all.empty() ? "}" : "\n}");
}

}  // namespace

std::string graphJson(const GraphFile& file) {
  const TopologyGraph& graph = file.graph.graph;
  JsonDocument document("roomgraph/graph", {{"name", file.program}, {"version", file.version}});
  document.add("input", inputJson(file.input));
  document.addText("options", optionsText(file.options));
  addList(document, "vertices", graph.vertices(), vertexText);
  addList(document, "edges", graph.edges(),
          [&](std::size_t id, const Edge& edge) { return edgeText(graph, id, edge); });
  addList(document, "rooms", file.graph.rooms, roomText);
  addList(document, "areas", file.areas.areas,
          [&](std::size_t id, const Area& area) { return areaText(file.areaNames, id, area); });
  addList(document, "passages", file.areas.passages, passageText);
  addList(document, "notes", file.notes, noteText);
  return std::move(document).text();
}

std::string graphJson(const Stages& stages) { return graphJson(graphFile(stages)); }

}  // namespace roomgraph
