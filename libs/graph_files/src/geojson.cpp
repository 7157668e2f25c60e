#include "roomgraph/graph_files/geojson.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "roomgraph/base/json_text.h"
#include "roomgraph/geometry/point_json.h"
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
  /** nav2 stops at null, so what a thing does not have is left out. */
  Members& number(const char* name, double value) {
    if (!std::isfinite(value)) return *this;
    std::string json;
    addNumber(json, value);
    return add(name, json);
  }
  Members& room(RoomId room) { return room ? add("room", room.index()) : *this; }
  std::string object() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

/** Full speed from here on [m]; nearer to obstacles in proportion, but never less than the least.
 */
constexpr double kFullSpeedClearance = 1, kLeastPercent = 20;

double speedPercent(double clearance) {
  return std::clamp(std::round(100 * clearance / kFullSpeedClearance), kLeastPercent, 100.0);
}

std::string pointText(Point p) {
  std::string json;
  addPoint(json, p);
  return json;
}

/** GeoJSON repeats the first point of a ring at its end. */
std::string closedRing(Ring ring) {
  if (!ring.empty()) ring.push_back(ring.front());
  std::string json;
  addPoints(json, ring);
  return json;
}

class Writer {
 public:
  explicit Writer(const RoomGraph& graph) : graph_(graph) {}

  std::string write() {
    for (std::size_t r = 0; r < graph_.rooms.size(); ++r) addRoomPolygon(r);
    for (const Vertex& vertex : graph_.graph.vertices())
      addNode(vertex.at, Members()
                             .quoted("class", kindName(vertex.kind))
                             .number("clearance", vertex.clearance)
                             .room(vertex.room));
    if (graph_.graph.edges().empty()) addLoneRooms();
    addBends();
    for (std::size_t e = 0; e < chains_.size(); ++e) addPieces(e);
    return "{\n\"type\": \"FeatureCollection\",\n\"name\": \"roomgraph\",\n\"crs\": {\"type\": "
           "\"name\", \"properties\": {\"name\": \"urn:ogc:def:crs:EPSG::3857\"}},\n"
           "\"features\": [" +
           features_ + "\n]\n}\n";
  }

 private:
  struct Node {
    std::size_t id;
    Point at;
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
    std::string rings = "[" + closedRing(room.polygon.outer);
    for (const Ring& hole : room.polygon.holes) rings += "," + closedRing(hole);
    addFeature(Members()
                   .add("room", r)
                   .number("area", area(room.polygon))
                   .number("inscribed_radius", room.inscribedRadius),
               "Polygon", rings + "]");
  }

  std::size_t addNode(Point at, const Members& metadata) {
    addFeature(
        Members().add("id", nextId_).quoted("frame", "map").add("metadata", metadata.object()),
        "Point", pointText(at));
    return nextId_++;
  }

  /** Finds the nodes along each edge; all nodes get their ids before the first edge does. */
  void addBends() {
    for (const Edge& edge : graph_.graph.edges()) {
      std::vector<Node> chain{{edge.source.index(), edge.path.points.front()}};
      const auto kept = straightPieces(edge.path);
      for (std::size_t i = 1; i + 1 < kept.size(); ++i) {
        const Point at = edge.path.points[kept[i]];
        chain.push_back({addNode(at, Members().quoted("class", "bend").room(edge.room)), at});
      }
      chain.push_back({edge.target.index(), edge.path.points.back()});
      chains_.push_back(std::move(chain));
    }
  }

  void addPieces(std::size_t e) {
    const Edge& edge = graph_.graph.edges()[e];
    const Members metadata = Members()
                                 .add("edge", e)
                                 .quoted("class", kindName(edge))
                                 .room(edge.room)
                                 .number("length", edge.path.length)
                                 .number("min_clearance", edge.path.minClearance);
    for (std::size_t i = 0; i + 1 < chains_[e].size(); ++i)
      addBothWays(chains_[e][i], chains_[e][i + 1], metadata, edge.path.minClearance);
  }

  /** The loader refuses a graph without edges: a room without a way out gets one inside of it. */
  void addLoneRooms() {
    std::vector<std::pair<Node, Node>> ways;
    for (std::size_t r = 0; r < graph_.rooms.size(); ++r) {
      const Room& room = graph_.rooms[r].shape;
      const Point aside{room.inscribedRadius / 2, 0};
      const Members inside = Members().quoted("class", "room").room(RoomId(r));
      const Point ends[] = {room.widestPlace - aside, room.widestPlace + aside};
      const std::size_t from = addNode(ends[0], inside), to = addNode(ends[1], inside);
      ways.push_back({{from, ends[0]}, {to, ends[1]}});
    }
    for (std::size_t r = 0; r < ways.size(); ++r) {
      const double clearance = graph_.rooms[r].shape.inscribedRadius / 2;
      addBothWays(
          ways[r].first, ways[r].second,
          Members().quoted("class", "room").room(RoomId(r)).number("min_clearance", clearance),
          clearance);
    }
  }

  void addBothWays(const Node& a, const Node& b, Members metadata, double clearance) {
    const double speed = speedPercent(clearance);
    metadata.number("speed_limit", speed)
        .number("penalty", distance(a.at, b.at) * (100 / speed - 1));
    addPiece(a, b, metadata);
    addPiece(b, a, metadata);
  }

  void addPiece(const Node& from, const Node& to, const Members& metadata) {
    addFeature(Members()
                   .add("id", nextId_++)
                   .add("startid", from.id)
                   .add("endid", to.id)
                   .number("cost", distance(from.at, to.at))
                   .add("overridable", "true")
                   .add("metadata", metadata.object()),
               "MultiLineString", "[[" + pointText(from.at) + "," + pointText(to.at) + "]]");
  }

  const RoomGraph& graph_;
  std::string features_;
  std::size_t nextId_ = 0;
  std::vector<std::vector<Node>> chains_;  // per edge, from its source to its target
};

}  // namespace

std::string geojson(const RoomGraph& graph) { return Writer(graph).write(); }

}  // namespace roomgraph
