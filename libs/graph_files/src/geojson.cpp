#include "roomgraph/graph_files/geojson.h"

#include <cmath>
#include <utility>

#include "roomgraph/base/Json.h"
#include "roomgraph/geometry/point_json.h"
#include "roomgraph/geometry/thinned_line.h"
#include "roomgraph/graph_files/area_pictures.h"
#include "roomgraph/rooms/reason_names.h"
#include "roomgraph/topology/kind_names.h"
#include "straight_pieces.h"

namespace roomgraph {
namespace {

/** The members of a JSON object, as text; names and texts are ours and need no escapes. */
class Members {
 public:
  Members& add(const char* name, const std::string& json) {
    text_ += (text_.empty() ? "\"" : ",\"") + std::string(name) + "\":" + json;
    return *this;
  }
  Members& add(const char* name, std::size_t id) { return add(name, std::to_string(id)); }
  Members& quoted(const char* name, const char* text) {
    return add(name, "\"" + std::string(text) + "\"");
  }
  /** nav2 stops at null, so what a thing does not have is left out; and where it wants a number it
   *  stops at one without a point, which it takes for an integer. */
  Members& number(const char* name, double value) {
    if (!std::isfinite(value)) return *this;
    std::string json;
    addNumber(json, value);
    if (json.find_first_of(".e") == std::string::npos) json += ".0";
    return add(name, json);
  }
  Members& room(RoomId room) { return room ? add("room", room.index()) : *this; }
  std::string object() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

std::string pointText(Point p) {
  std::string json;
  addPoint(json, p);
  return json;
}

/** GeoJSON repeats the first point of a ring at its end. It may be off by `tolerance` [m]. */
std::string closedRing(Ring ring, double tolerance) {
  if (!ring.empty()) ring.push_back(ring.front());
  const Ring thinned = thinnedLine(ring, tolerance);
  std::string json;
  addPoints(json, thinned.size() > 3 ? thinned : ring);
  return json;
}

class Writer {
 public:
  Writer(const RoomGraph& graph, const ObstacleRows& obstacles, double clearance,
         const std::vector<Passage>& passages, const std::vector<std::string>& roomNames)
      : graph_(graph),
        obstacles_(obstacles),
        clearance_(clearance),
        passages_(passages),
        roomNames_(roomNames) {}

  std::string write() {
    for (std::size_t r = 0; r < graph_.rooms.size(); ++r) addRoomPolygon(r);
    for (std::size_t p = 0; p < passages_.size(); ++p) addPassage(p);
    for (const Vertex& vertex : graph_.graph.vertices())
      addNode(vertex.place, Members()
                                .quoted("class", nameOf(vertex.kind))
                                .number("clearance", vertex.clearance)
                                .room(vertex.room));
    addBends();
    const auto loneWays = addLoneWays();
    for (std::size_t e = 0; e < chains_.size(); ++e) addPieces(e);
    for (const auto& [from, to] : loneWays)
      addBothWays(from, to, Members().quoted("class", "room"), distance(from.place, to.place));
    return "{\n\"type\": \"FeatureCollection\",\n\"name\": \"roomgraph\",\n\"crs\": {\"type\": "
           "\"name\", \"properties\": {\"name\": \"urn:ogc:def:crs:EPSG::3857\"}},\n"
           "\"features\": [" +
           features_ + "\n]\n}\n";
  }

 private:
  struct Node {
    std::size_t id;
    Point place;
  };

  void addFeature(const Members& properties, const char* type, const std::string& coordinates) {
    const Members geometry = Members().quoted("type", type).add("coordinates", coordinates);
    features_ += (features_.empty() ? "\n" : ",\n") + Members()
                                                          .quoted("type", "Feature")
                                                          .add("properties", properties.object())
                                                          .add("geometry", geometry.object())
                                                          .object();
  }

  void addRoomPolygon(std::size_t r) {
    const Room& room = graph_.rooms[r].shape;
    const double step = obstacles_.cellSide();  // of the stairs that a slanted or rough wall makes
    std::string rings = "[" + closedRing(room.polygon.outer, step);
    for (const Ring& hole : room.polygon.holes) rings += "," + closedRing(hole, step);
    Members properties;
    properties.add("room", r);
    if (!roomNames_.empty()) properties.add("name", lineOf(Json(roomNames_[r])));
    addFeature(properties.number("area", area(room.polygon))
                   .number("inscribed_radius", room.inscribedRadius),
               "Polygon", rings + "]");
  }

  void addPassage(std::size_t p) {
    const Passage& passage = passages_[p];
    Members properties;
    properties.add("passage", p)
        .number("width", passage.width)
        .number("confidence", passage.evidence.confidence)
        .quoted("evidence", nameOf(passage.evidence.reason));
    addFeature(properties, "MultiPoint",
               "[" + pointText(passage.from) + "," + pointText(passage.to) + "]");
  }

  std::size_t addNode(Point place, const Members& metadata) {
    addFeature(
        Members().add("id", nextId_).quoted("frame", "map").add("metadata", metadata.object()),
        "Point", pointText(place));
    return nextId_++;
  }

  /** Finds the nodes along each edge; all nodes get their ids before the first edge does. */
  void addBends() {
    for (const Edge& edge : graph_.graph.edges()) {
      std::vector<Node> chain{{edge.source.index(), edge.path.points.front()}};
      const auto kept = straightPieces(edge.path, obstacles_, clearance_);
      for (std::size_t i = 1; i + 1 < kept.size(); ++i) {
        const Point point = edge.path.points[kept[i]];
        chain.push_back({addNode(point, Members().quoted("class", "bend").room(edge.room)), point});
      }
      chain.push_back({edge.target.index(), edge.path.points.back()});
      chains_.push_back(std::move(chain));
    }
  }

  void addPieces(std::size_t e) {
    const Edge& edge = graph_.graph.edges()[e];
    const Members metadata = Members()
                                 .add("edge", e)
                                 .quoted("class", kindName(graph_.graph, edge))
                                 .room(edge.room)
                                 .number("length", edge.path.length);
    for (std::size_t i = 0; i + 1 < chains_[e].size(); ++i) {
      const Node &from = chains_[e][i], &to = chains_[e][i + 1];
      addBothWays(from, to, metadata,
                  obstacles_.clearance(from.place, to.place, edge.path.minClearance));
    }
  }

  /** The loader refuses a graph without edges, and a place without a way is none: it gets one
   *  within its own disc, to a place half as far away as the nearest obstacle. */
  std::vector<std::pair<Node, Node>> addLoneWays() {
    std::vector<std::pair<Node, Node>> ways;
    const auto& vertices = graph_.graph.vertices();
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (graph_.graph.degree(VertexId(v)) > 0) continue;
      const Point aside = vertices[v].place + Point{vertices[v].clearance / 2, 0};
      const Members bend = Members().quoted("class", "bend").room(vertices[v].room);
      ways.push_back({{v, vertices[v].place}, {addNode(aside, bend), aside}});
    }
    return ways;
  }

  void addBothWays(const Node& a, const Node& b, Members metadata, double clearance) {
    const double speed = speedPercent(clearance);
    metadata.number("min_clearance", clearance)
        .number("speed_limit", speed)
        .number("penalty", distance(a.place, b.place) * (100 / speed - 1));
    addPiece(a, b, metadata);
    addPiece(b, a, metadata);
  }

  void addPiece(const Node& from, const Node& to, const Members& metadata) {
    addFeature(Members()
                   .add("id", nextId_++)
                   .add("startid", from.id)
                   .add("endid", to.id)
                   .number("cost", distance(from.place, to.place))
                   .add("overridable", "true")
                   .add("metadata", metadata.object()),
               "MultiLineString", "[[" + pointText(from.place) + "," + pointText(to.place) + "]]");
  }

  const RoomGraph& graph_;
  const ObstacleRows& obstacles_;
  double clearance_;
  const std::vector<Passage>& passages_;
  const std::vector<std::string>& roomNames_;
  std::string features_;
  std::size_t nextId_ = 0;
  std::vector<std::vector<Node>> chains_;  // per edge, from its source to its target
};

}  // namespace

std::string geojson(const RoomGraph& graph, const ObstacleRows& obstacles, double clearance,
                    const std::vector<Passage>& passages,
                    const std::vector<std::string>& roomNames) {
  return Writer(graph, obstacles, clearance, passages, roomNames).write();
}

}  // namespace roomgraph
