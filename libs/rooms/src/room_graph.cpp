#include "roomgraph/rooms/room_graph.h"

#include <algorithm>

#include "roomgraph/geometry/intersect.h"
#include "roomgraph/rooms/inner_paths.h"

namespace roomgraph {
namespace {

/** What of the topology graph belongs to one room. */
struct RoomParts {
  std::vector<EdgeId> innerEdges;
  std::vector<VertexId> borderVertices;
  bool isEntered = false;
};

std::vector<RoomParts> collectParts(const TopologyGraph& graph, std::size_t roomCount) {
  std::vector<RoomParts> parts(roomCount);
  const auto addBorder = [&](RoomId room, VertexId v) {
    auto& borders = parts[room.index()].borderVertices;
    if (std::find(borders.begin(), borders.end(), v) == borders.end()) borders.push_back(v);
  };
  for (std::size_t v = 0; v < graph.vertices().size(); ++v) {
    const Vertex& vertex = graph.vertices()[v];
    if (!vertex.room) continue;
    parts[vertex.room.index()].isEntered = true;
    if (vertex.kind == VertexKind::border) addBorder(vertex.room, VertexId(v));
  }
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const Edge& edge = graph.edges()[e];
    if (!edge.room) continue;
    RoomParts& room = parts[edge.room.index()];
    room.isEntered = true;
    room.innerEdges.push_back(EdgeId(e));
    for (const VertexId end : {edge.source, edge.target})
      if (graph.vertex(end).kind == VertexKind::border) addBorder(edge.room, end);
  }
  for (RoomParts& room : parts) std::sort(room.borderVertices.begin(), room.borderVertices.end());
  return parts;
}

/** Whether a straight way from inside the polygon to a border vertex leaves it in between. */
bool leavesPolygon(const Polygon& polygon, Point from, Point to, double tolerance) {
  const double way = distance(from, to);
  const auto isCrossedBefore = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (const double at : intersect(from, to, ring[i], ring[(i + 1) % ring.size()]))
        if ((1 - at) * way > tolerance) return true;
    return false;
  };
  return isCrossedBefore(polygon.outer) ||
         std::any_of(polygon.holes.begin(), polygon.holes.end(), isCrossedBefore);
}

class RoomBuilder {
 public:
  RoomBuilder(const TopologyGraph& graph, const ObstacleRows& obstacles, double clearance,
              bool straightEdges)
      : graph_(graph), obstacles_(obstacles), clearance_(clearance), straight_(straightEdges) {}

  /** Where the room's vertex stands, and its paths to the room's border vertices. */
  InnerPaths build(const Room& room, const RoomParts& parts) const {
    const Point center = centroid(room.polygon);
    InnerPaths star = straightPaths(room, parts, center);
    if (straight_) return star;
    const bool isInside = sideOf(room.polygon, center) == Side::inside;
    if (isInside && star.clearance >= clearance_ && allAreClear(room, star)) return star;
    if (!parts.innerEdges.empty())
      // Half as wide as the room gets: not in a door, nor in a corner.
      return innerPaths(graph_, parts.innerEdges, parts.borderVertices, center,
                        room.inscribedRadius / 2);
    return straightPaths(room, parts, room.widestPlace);
  }

 private:
  InnerPaths straightPaths(const Room& room, const RoomParts& parts, Point center) const {
    InnerPaths star;
    star.center = center;
    star.clearance = obstacles_.clearance(center, center, room.inscribedRadius);
    for (const VertexId v : parts.borderVertices) {
      const Vertex& border = graph_.vertex(v);
      Path path;
      path.points = {center, border.at};
      path.length = distance(center, border.at);
      path.minClearance = obstacles_.clearance(center, border.at, border.clearance);
      star.paths.push_back(std::move(path));
    }
    return star;
  }

  bool allAreClear(const Room& room, const InnerPaths& star) const {
    return std::all_of(star.paths.begin(), star.paths.end(), [&](const Path& path) {
      // A border vertex in the middle of a door lies a little outside of the polygon.
      const double tolerance = 2 * clearance_;
      return path.minClearance >= clearance_ &&
             !leavesPolygon(room.polygon, path.points.front(), path.points.back(), tolerance);
    });
  }

  const TopologyGraph& graph_;
  const ObstacleRows& obstacles_;
  double clearance_;
  bool straight_;
};

Note unreachedNote(const Room& room) {
  return {"room_unreached", "a room is left out: no way of the graph leads into it",
          std::array<double, 2>{room.widestPlace.x, room.widestPlace.y}};
}

/** The vertices and edges that are not inside of a room, with the rooms' new numbers. */
TopologyGraph outerGraph(const TopologyGraph& graph, const std::vector<RoomId>& newRoom,
                         std::vector<VertexId>& newId) {
  std::vector<Vertex> vertices;
  for (std::size_t v = 0; v < graph.vertices().size(); ++v) {
    Vertex vertex = graph.vertices()[v];
    if (vertex.room && vertex.kind != VertexKind::border) continue;
    if (vertex.room) vertex.room = newRoom[vertex.room.index()];
    newId[v] = VertexId(vertices.size());
    vertices.push_back(vertex);
  }
  std::vector<Edge> edges;
  for (Edge edge : graph.edges()) {
    if (edge.room) continue;
    edge.source = newId[edge.source.index()];
    edge.target = newId[edge.target.index()];
    edges.push_back(std::move(edge));
  }
  return {std::move(vertices), std::move(edges)};
}

}  // namespace

void describe(RoomGraphOptions& options, FieldTable& table) {
  table.flag("room_graph", "straight_edges", options.straightEdges,
             "Join rooms to their border vertices by straight edges from the centroid, whatever "
             "lies between, as the paper does.");
}

RoomGraph roomGraph(const TopologyGraph& graph, const Rooms& rooms, const ObstacleRows& obstacles,
                    double clearance, const RoomGraphOptions& options, Notes& notes) {
  const std::vector<RoomParts> parts = collectParts(graph, rooms.size());
  std::vector<RoomId> newRoom(rooms.size());
  std::size_t count = 0;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    if (parts[r].isEntered)
      newRoom[r] = RoomId(count++);
    else
      notes.push_back(unreachedNote(rooms[r]));
  }
  std::vector<VertexId> newId(graph.vertices().size());
  TopologyGraph outer = outerGraph(graph, newRoom, newId);
  std::vector<Vertex> vertices = outer.vertices();
  std::vector<Edge> edges = std::move(outer).takeEdges();

  RoomGraph result;
  const RoomBuilder builder(graph, obstacles, clearance, options.straightEdges);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    if (!newRoom[r]) continue;
    InnerPaths inner = builder.build(rooms[r], parts[r]);
    GraphRoom room{rooms[r], inner.center, VertexId(vertices.size()), {}};
    vertices.push_back({inner.center, inner.clearance, VertexKind::room, newRoom[r]});
    for (std::size_t i = 0; i < inner.paths.size(); ++i) {
      room.borderVertices.push_back(newId[parts[r].borderVertices[i].index()]);
      edges.push_back(
          {room.vertex, room.borderVertices.back(), std::move(inner.paths[i]), newRoom[r]});
    }
    result.rooms.push_back(std::move(room));
  }
  result.graph = TopologyGraph(std::move(vertices), std::move(edges));
  return result;
}

}  // namespace roomgraph
