#include "roomgraph/rooms/room_graph.h"

#include <algorithm>

#include "roomgraph/base/sequences.h"
#include "roomgraph/rooms/hall_ways.h"
#include "roomgraph/rooms/inner_ways.h"
#include "roomgraph/topology/VoronoiGraph.h"
#include "straight_ways.h"

namespace roomgraph {
namespace {

/** What of the topology graph belongs to one room. */
struct RoomParts {
  std::vector<EdgeId> innerEdges;
  std::vector<VertexId> borderVertices;
  VertexId widest;  ///< none where nothing of the graph is in the room
};

std::vector<RoomParts> collectParts(const TopologyGraph& graph, std::size_t roomCount) {
  std::vector<RoomParts> parts(roomCount);
  const auto addVertex = [&](RoomId room, VertexId v) {
    const Vertex& vertex = graph.vertex(v);
    VertexId& widest = parts[room.index()].widest;
    if (!widest || vertex.clearance > graph.vertex(widest).clearance) widest = v;
    auto& borders = parts[room.index()].borderVertices;
    if (vertex.kind == VertexKind::border &&
        std::find(borders.begin(), borders.end(), v) == borders.end())
      borders.push_back(v);
  };
  for (std::size_t v = 0; v < graph.vertices().size(); ++v)
    if (graph.vertices()[v].room) addVertex(graph.vertices()[v].room, VertexId(v));
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const Edge& edge = graph.edges()[e];
    if (!edge.room) continue;
    parts[edge.room.index()].innerEdges.push_back(EdgeId(e));
    for (const VertexId end : {edge.source, edge.target}) addVertex(edge.room, end);
  }
  for (RoomParts& room : parts) std::sort(room.borderVertices.begin(), room.borderVertices.end());
  return parts;
}

/** The straight ways from one place in a room to its border vertices. */
struct Star {
  Point center;
  double clearance = 0;     // there [m]
  std::vector<Path> paths;  // in the order of the border vertices
};

/** The same as a graph, with those first. */
TopologyGraph graphOf(const TopologyGraph& graph, const std::vector<VertexId>& borders, Star star) {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  const VertexId middle(borders.size());
  for (std::size_t i = 0; i < borders.size(); ++i) {
    vertices.push_back(graph.vertex(borders[i]));
    edges.push_back({middle, VertexId(i), std::move(star.paths[i]), {}});
  }
  vertices.push_back({star.center, star.clearance, VertexKind::room, {}});
  return {std::move(vertices), std::move(edges)};
}

class RoomBuilder {
 public:
  RoomBuilder(const TopologyGraph& graph, const ObstacleRows& obstacles, double clearance,
              const RoomGraphOptions& options)
      : graph_(graph), obstacles_(obstacles), clearance_(clearance), options_(options) {}

  /** The room's vertex and its ways to the border vertices, which come first. */
  TopologyGraph build(const Room& room, const RoomParts& parts) const {
    TopologyGraph ways = waysOf(room, parts);
    if (options_.straightEdges) return ways;
    const double widths = (options_.robotWidth / 2 + obstacles_.cellSide() / 2) * (1 - kSameWidth);
    return hallWays(std::move(ways), room, obstacles_, std::max(clearance_, widths));
  }

 private:
  TopologyGraph waysOf(const Room& room, const RoomParts& parts) const {
    const Point middle = centroid(room.polygon);
    const bool followsPaths = !options_.straightEdges && !parts.innerEdges.empty();
    if (followsPaths) {
      TopologyGraph ways =
          innerWays(graph_, parts.innerEdges, options_.robotWidth, obstacles_.cellSide() / 2);
      if (!ways.edges().empty())
        return withRoomVertex(std::move(ways), middle, leastClearance(room));
    }
    Star star = straightStar(room, parts, middle);
    if (!options_.straightEdges && !isClear(room, star)) {
      if (followsPaths) return innerTree(graph_, parts.innerEdges, middle, leastClearance(room));
      star = straightStar(room, parts, graph_.vertex(parts.widest).place);
    }
    return graphOf(graph_, parts.borderVertices, std::move(star));
  }

  /** Half as wide as the room gets: not in a door, nor in a corner. */
  static double leastClearance(const Room& room) { return room.inscribedRadius / 2; }

  Star straightStar(const Room& room, const RoomParts& parts, Point center) const {
    Star star;
    star.center = center;
    star.clearance = obstacles_.clearance(center, center, room.inscribedRadius);
    for (const VertexId v : parts.borderVertices)
      star.paths.push_back(
          straightPath(obstacles_, center, graph_.vertex(v).place, graph_.vertex(v).clearance));
    return star;
  }

  bool isClear(const RoomIndex& index, const Path& path) const {
    // A border vertex in the middle of a door lies a little outside of the polygon.
    const double tolerance = 2 * clearance_;
    return path.minClearance >= clearance_ &&
           !leavesRoom(index, path.points.front(), path.points.back(), tolerance);
  }

  /** Whether it lies in the room, and each of its paths is clear. */
  bool isClear(const Room& room, const Star& star) const {
    if (sideOf(room.polygon, star.center) != Side::inside || star.clearance < clearance_)
      return false;
    const RoomIndex index({room}, clearance_);
    return allOf(star.paths, [&](const Path& path) { return isClear(index, path); });
  }

  const TopologyGraph& graph_;
  const ObstacleRows& obstacles_;
  double clearance_;
  const RoomGraphOptions& options_;
};

/** Adds the ways of a room, whose first vertices are its border vertices. */
void addRoom(const TopologyGraph& ways, RoomId id, GraphRoom room, std::vector<Vertex>& vertices,
             std::vector<Edge>& edges, RoomGraph& result) {
  const std::size_t borderCount = room.borderVertices.size(), first = vertices.size();
  for (std::size_t v = borderCount; v < ways.vertices().size(); ++v) {
    vertices.push_back(ways.vertices()[v]);
    vertices.back().room = id;
    if (vertices.back().kind != VertexKind::room) continue;
    room.vertex = VertexId(vertices.size() - 1);
    room.center = vertices.back().place;
  }
  const auto newId = [&](VertexId v) {
    return v.index() < borderCount ? room.borderVertices[v.index()]
                                   : VertexId(first + v.index() - borderCount);
  };
  for (Edge edge : ways.edges()) {
    edge.source = newId(edge.source), edge.target = newId(edge.target);
    edge.room = id;
    edges.push_back(std::move(edge));
  }
  result.rooms.push_back(std::move(room));
}

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
  table.number("room_graph", "robot_width", options.robotWidth, "m", 0, 10,
               "Least width of the ways inside rooms; ways that add nothing are left out.");
}

RoomGraph roomGraph(const TopologyGraph& graph, const Rooms& rooms, const ObstacleRows& obstacles,
                    double clearance, const RoomGraphOptions& options, Notes& notes) {
  const std::vector<RoomParts> parts = collectParts(graph, rooms.size());
  std::vector<RoomId> newRoom(rooms.size());
  std::size_t count = 0;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    if (parts[r].widest)
      newRoom[r] = RoomId(count++);
    else
      notes.push_back(unreachedNote(rooms[r]));
  }
  std::vector<VertexId> newId(graph.vertices().size());
  TopologyGraph outer = outerGraph(graph, newRoom, newId);
  std::vector<Vertex> vertices = outer.vertices();
  std::vector<Edge> edges = std::move(outer).takeEdges();

  RoomGraph result;
  const RoomBuilder builder(graph, obstacles, clearance, options);
  const auto borders = [&](std::size_t r) {
    std::vector<VertexId> ids;
    for (const VertexId v : parts[r].borderVertices) ids.push_back(newId[v.index()]);
    return ids;
  };
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    if (!newRoom[r]) continue;
    addRoom(builder.build(rooms[r], parts[r]), newRoom[r], GraphRoom{rooms[r], {}, {}, borders(r)},
            vertices, edges, result);
  }
  result.graph = TopologyGraph(std::move(vertices), std::move(edges));
  return result;
}

}  // namespace roomgraph
