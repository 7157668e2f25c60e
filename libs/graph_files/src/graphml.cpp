#include "roomgraph/graph_files/graphml.h"

#include <cmath>

#include "roomgraph/base/Json.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/topology/kind_names.h"

namespace roomgraph {
namespace {

struct Key {
  const char *id, *target, *name, *type, *sentence;
};

constexpr Key kKeys[] = {
    {"x", "node", "x", "double", "place, map frame [m]"},
    {"y", "node", "y", "double", "place, map frame [m]"},
    {"kind", "node", "kind", "string", "junction, dead_end, border, room or ring"},
    {"clearance", "node", "clearance", "double", "distance to the nearest obstacle [m]"},
    {"room", "node", "room", "int", "id of the room that it stands for, lies in or borders"},
    {"area", "node", "area", "double", "of the room that it stands for [m2]"},
    {"edge_kind", "edge", "kind", "string", "corridor, room or way"},
    {"edge_room", "edge", "room", "int", "id of the room that it runs in"},
    {"length", "edge", "length", "double", "of the path [m]"},
    {"min_clearance", "edge", "min_clearance", "double",
     "smallest distance to an obstacle along the path [m]"},
    {"path", "edge", "path", "string", "the points of the path, map frame, as WKT [m]"},
};

void data(std::string& xml, const char* key, const std::string& value) {
  xml += std::string("<data key=\"") + key + "\">" + value + "</data>";
}

/** Left out where nothing bounds the number. */
void data(std::string& xml, const char* key, double value) {
  if (!std::isfinite(value)) return;
  data(xml, key, numberText(rounded(value)));
}

/** As well-known text: LINESTRING(0 0,1.5 2). */
std::string lineText(const Polyline& points) {
  std::string text;
  for (const Point p : points)
    text += (text.empty() ? "" : ",") + numberText(rounded(p.x)) + " " + numberText(rounded(p.y));
  return "LINESTRING(" + text + ")";
}

void data(std::string& xml, const char* key, RoomId room) {
  if (room) data(xml, key, std::to_string(room.index()));
}

void addNode(std::string& xml, const RoomGraph& graph, std::size_t v) {
  const Vertex& vertex = graph.graph.vertices()[v];
  xml += "    <node id=\"n" + std::to_string(v) + "\">";
  data(xml, "x", vertex.place.x);
  data(xml, "y", vertex.place.y);
  data(xml, "kind", std::string(nameOf(vertex.kind)));
  data(xml, "clearance", vertex.clearance);
  data(xml, "room", vertex.room);
  if (vertex.kind == VertexKind::room && vertex.room)
    data(xml, "area", area(graph.rooms[vertex.room.index()].shape.polygon));
  xml += "</node>\n";
}

void addEdge(std::string& xml, const RoomGraph& graph, std::size_t e) {
  const Edge& edge = graph.graph.edges()[e];
  xml += "    <edge id=\"e" + std::to_string(e) + "\" source=\"n" +
         std::to_string(edge.source.index()) + "\" target=\"n" +
         std::to_string(edge.target.index()) + "\">";
  data(xml, "edge_kind", std::string(kindName(graph.graph, edge)));
  data(xml, "edge_room", edge.room);
  data(xml, "length", edge.path.length);
  data(xml, "min_clearance", edge.path.minClearance);
  data(xml, "path", lineText(edge.path.points));
  xml += "</edge>\n";
}

}  // namespace

std::string graphml(const RoomGraph& graph) {
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\""
      " xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\""
      " xsi:schemaLocation=\"http://graphml.graphdrawing.org/xmlns"
      " http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd\">\n";
  for (const Key& key : kKeys)
    xml += std::string("  <key id=\"") + key.id + "\" for=\"" + key.target + "\" attr.name=\"" +
           key.name + "\" attr.type=\"" + key.type + "\"><desc>" + key.sentence + "</desc></key>\n";
  xml += "  <graph id=\"roomgraph\" edgedefault=\"undirected\">\n";
  for (std::size_t v = 0; v < graph.graph.vertices().size(); ++v) addNode(xml, graph, v);
  for (std::size_t e = 0; e < graph.graph.edges().size(); ++e) addEdge(xml, graph, e);
  return xml + "  </graph>\n</graphml>\n";
}

}  // namespace roomgraph
