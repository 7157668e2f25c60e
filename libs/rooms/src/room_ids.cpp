#include "roomgraph/rooms/room_ids.h"

#include <algorithm>
#include <limits>

#include "roomgraph/rooms/RoomIndex.h"

namespace roomgraph {
namespace {

/** The room of a vertex by the paths that end at it. */
void setRoom(Vertex& vertex, VertexId v, const TopologyGraph& graph) {
  const auto out = graph.outgoing(v);
  const RoomId first = graph.edge(out.front()).room;
  RoomId smallest = first;
  bool isMixed = false;
  for (const HalfEdgeId h : out) {
    smallest = std::min(smallest, graph.edge(h).room);
    isMixed = isMixed || graph.edge(h).room != first;
  }
  vertex.room = smallest;
  if (isMixed) vertex.kind = VertexKind::border;
}

/** The border vertex at which a dead end starts, if it does; else none. */
VertexId borderBase(const TopologyGraph& graph, const Edge& edge) {
  for (const auto& [tip, base] : {std::pair(edge.source, edge.target),
                                  std::pair(edge.target, edge.source)})
    if (graph.degree(tip) == 1 && graph.vertex(base).kind == VertexKind::border) return base;
  return VertexId::none();
}

}  // namespace

TopologyGraph roomIds(TopologyGraph graph, const Rooms& rooms, double minLength) {
  std::vector<Vertex> vertices = graph.vertices();
  constexpr double noOpenings = std::numeric_limits<double>::infinity();
  const RoomIndex index(rooms, noOpenings);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (graph.degree(VertexId(v)) == 0)
      vertices[v].room = index.roomAt(vertices[v].at);
    else
      setRoom(vertices[v], VertexId(v), graph);
  }
  graph = TopologyGraph(std::move(vertices), std::move(graph).takeEdges());
  std::vector<RoomId> newRoom;
  for (const Edge& edge : graph.edges()) {
    const VertexId base = edge.room ? VertexId::none() : borderBase(graph, edge);
    const bool isShort = base && edge.path.length < minLength;
    newRoom.push_back(isShort ? graph.vertex(base).room : edge.room);
  }
  std::vector<Vertex> kept = graph.vertices();
  std::vector<Edge> edges = std::move(graph).takeEdges();
  for (std::size_t e = 0; e < edges.size(); ++e) edges[e].room = newRoom[e];
  return {std::move(kept), std::move(edges)};
}

}  // namespace roomgraph
