#include "roomgraph/rooms/join_doors.h"

#include <algorithm>

#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

/** A border vertex with a single way that is not inside of its room. */
bool hasOneCorridor(const TopologyGraph& graph, VertexId v) {
  const auto out = graph.outgoing(v);
  return graph.vertex(v).kind == VertexKind::border &&
         countIf(out, [&](HalfEdgeId h) { return !graph.edge(h).room; }) == 1;
}

bool isDoor(const TopologyGraph& graph, const Edge& edge, double maxDepth) {
  return !edge.room && edge.path.length <= maxDepth && hasOneCorridor(graph, edge.source) &&
         hasOneCorridor(graph, edge.target) &&
         graph.vertex(edge.source).room != graph.vertex(edge.target).room;
}

}  // namespace

void describe(JoinDoorsOptions& options, FieldTable& table) {
  table.number(
      "join_doors", "max_depth", options.maxDepth, "m", 0, 10,
      "A corridor up to this length between two rooms that a disc has found is one door with one "
      "border vertex.");
}

TopologyGraph joinDoors(TopologyGraph graph, const JoinDoorsOptions& options) {
  std::vector<Vertex> vertices = graph.vertices();
  // Per vertex: the door's vertex it becomes, and the way there.
  std::vector<VertexId> newId(vertices.size());
  std::vector<Path> way(vertices.size());
  std::vector<bool> keepEdge(graph.edges().size(), true), keepVertex(vertices.size(), true);
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const Edge& edge = graph.edges()[e];
    if (!isDoor(graph, edge, options.maxDepth)) continue;
    const double middle = edge.path.length / 2;
    const std::size_t s = edge.source.index(), t = edge.target.index();
    way[s] = piece(edge.path, 0, middle);
    way[t] = reversed(piece(edge.path, middle, edge.path.length));
    newId[s] = newId[t] = edge.source;
    vertices[s].place = way[s].points.back();
    vertices[s].clearance = distance(vertices[s].place, way[s].obstacles.back());
    vertices[s].room = std::min(vertices[s].room, vertices[t].room);
    keepVertex[t] = false;
    keepEdge[e] = false;
  }
  std::vector<Edge> edges = std::move(graph).takeEdges();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    Edge& edge = edges[e];
    if (!keepEdge[e]) continue;
    const std::size_t s = edge.source.index(), t = edge.target.index();
    if (newId[t]) edge.path = joined(std::move(edge.path), way[t]);
    if (newId[s]) edge.path = joined(reversed(way[s]), edge.path);
    if (newId[s]) edge.source = newId[s];
    if (newId[t]) edge.target = newId[t];
  }
  return keepOnly(TopologyGraph(std::move(vertices), std::move(edges)), keepVertex, keepEdge);
}

}  // namespace roomgraph
