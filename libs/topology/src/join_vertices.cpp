#include "roomgraph/topology/join_vertices.h"

#include <utility>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sequences.h"
#include "vertex_rank.h"

namespace roomgraph {
namespace {

/** Edges short enough to vanish, the shortest first, as a forest: none closes a cycle. */
std::vector<EdgeId> joiningForest(const TopologyGraph& graph, double limit, UnionFind& groups) {
  std::vector<EdgeId> shortEdges;
  for (std::size_t e = 0; e < graph.edges().size(); ++e)
    if (graph.edges()[e].path.length <= limit && !graph.isDeadEnd(EdgeId(e)))
      shortEdges.push_back(EdgeId(e));
  sortBy(shortEdges, [&](EdgeId e) { return graph.edge(e).path.length; });
  std::vector<EdgeId> forest;
  for (const EdgeId e : shortEdges)
    if (groups.join(graph.edge(e).source.index(), graph.edge(e).target.index()))
      forest.push_back(e);
  return forest;
}

/** For each vertex the one that stands for its group: the nearest to the group's mean; of two that
 *  are as near, as two always are, that with more space, or nearer to the middle of the graph. */
std::vector<VertexId> representatives(const TopologyGraph& graph, UnionFind& groups) {
  const auto& vertices = graph.vertices();
  std::vector<Point> sum(vertices.size());
  std::vector<int> count(vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    sum[groups.find(v)] = sum[groups.find(v)] + vertices[v].place;
    ++count[groups.find(v)];
  }
  const Point middle = middleOf(vertices);
  std::vector<VertexId> best(vertices.size());
  const auto key = [&](VertexId v, std::uint32_t group) {
    const Vertex& vertex = graph.vertex(v);
    return std::pair(float(distance(vertex.place, (1.0 / count[group]) * sum[group])),
                     vertexRank(vertex, middle));
  };
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const auto group = groups.find(v);
    if (!best[group] || key(VertexId(v), group) < key(best[group], group))
      best[group] = VertexId(v);
  }
  for (std::uint32_t v = 0; v < vertices.size(); ++v) best[v] = best[groups.find(v)];
  return best;
}

/** For each vertex the path along the forest to its representative. */
std::vector<Path> pathsToRepresentatives(const TopologyGraph& graph,
                                         const std::vector<EdgeId>& forest,
                                         const std::vector<VertexId>& representative) {
  std::vector<std::vector<HalfEdgeId>> ways(graph.vertices().size());
  for (const EdgeId e : forest)
    for (const HalfEdgeId h : {HalfEdgeId(2 * e.index()), HalfEdgeId(2 * e.index() + 1)})
      ways[graph.source(h).index()].push_back(h);
  std::vector<Path> paths(graph.vertices().size());
  std::vector<VertexId> open;
  for (std::size_t v = 0; v < graph.vertices().size(); ++v) {
    paths[v].points = {graph.vertices()[v].place};
    paths[v].minClearance = graph.vertices()[v].clearance;
    if (representative[v] == VertexId(v) && !ways[v].empty()) open.push_back(VertexId(v));
  }
  std::vector<bool> isDone(graph.vertices().size());
  while (!open.empty()) {
    const VertexId at = open.back();
    open.pop_back();
    isDone[at.index()] = true;
    for (const HalfEdgeId out : ways[at.index()]) {
      const VertexId next = graph.target(out);
      if (isDone[next.index()]) continue;
      paths[next.index()] = joined(graph.halfPath(TopologyGraph::twin(out)), paths[at.index()]);
      open.push_back(next);
    }
  }
  return paths;
}

}  // namespace

void describe(JoinVerticesOptions& options, FieldTable& table) {
  const char* section = "join_vertices";
  table.number(section, "max_distance", options.maxDistance, "m", 0, 10,
               "Vertices that a path up to this length connects become one.");
  table.number(section, "max_distance_px", options.maxDistancePx, "px", 0, 1000,
               "The same in cells; 0 for max_distance.");
}

TopologyGraph joinVertices(TopologyGraph graph, const JoinVerticesOptions& options,
                           double resolution) {
  const double limit =
      options.maxDistancePx > 0 ? options.maxDistancePx * resolution : options.maxDistance;
  UnionFind groups(graph.vertices().size());
  const std::vector<EdgeId> forest = joiningForest(graph, limit, groups);
  if (forest.empty()) return graph;
  const std::vector<VertexId> representative = representatives(graph, groups);
  const std::vector<Path> toRepresentative = pathsToRepresentatives(graph, forest, representative);

  std::vector<bool> keepVertex(graph.vertices().size()), keepEdge(graph.edges().size(), true);
  for (std::size_t v = 0; v < keepVertex.size(); ++v)
    keepVertex[v] = representative[v] == VertexId(v);
  for (const EdgeId e : forest) keepEdge[e.index()] = false;
  std::vector<Vertex> vertices = graph.vertices();
  std::vector<Edge> edges = std::move(graph).takeEdges();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    Edge& edge = edges[e];
    const VertexId source = edge.source, target = edge.target;
    edge.source = representative[source.index()];
    edge.target = representative[target.index()];
    if (!keepEdge[e]) continue;
    if (edge.source != source)
      edge.path = joined(reversed(toRepresentative[source.index()]), edge.path);
    if (edge.target != target)
      edge.path = joined(std::move(edge.path), toRepresentative[target.index()]);
  }
  return keepOnly(TopologyGraph(std::move(vertices), std::move(edges)), keepVertex, keepEdge);
}

}  // namespace roomgraph
