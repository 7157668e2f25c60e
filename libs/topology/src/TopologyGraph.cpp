#include "roomgraph/topology/TopologyGraph.h"

#include "roomgraph/topology/chains.h"
#include "vertex_rank.h"

namespace roomgraph {
namespace {

/** Junctions and dead ends are what their number of ways makes them. */
void setKind(Vertex& vertex, std::size_t degree) {
  if (vertex.kind == VertexKind::junction || vertex.kind == VertexKind::deadEnd)
    vertex.kind = degree == 1 ? VertexKind::deadEnd : VertexKind::junction;
}

bool isThrough(const TopologyGraph& graph, VertexId v) {
  const VertexKind kind = graph.vertex(v).kind;
  return graph.degree(v) == 2 && (kind == VertexKind::junction || kind == VertexKind::deadEnd);
}

/** The edges along one chain as one edge. */
Edge joinedEdge(const TopologyGraph& graph, const Step* first, const Step* last) {
  const auto half = [](Step s) { return HalfEdgeId(2 * std::size_t(s.link) + !s.isForward); };
  Edge edge;
  edge.source = graph.source(half(*first));
  edge.path = graph.halfPath(half(*first));
  edge.room = graph.edge(half(*first)).room;
  for (const Step* step = first + 1; step != last; ++step)
    edge.path = joined(std::move(edge.path), graph.halfPath(half(*step)));
  edge.target = graph.target(half(*(last - 1)));
  return edge;
}

}  // namespace

TopologyGraph::TopologyGraph(std::vector<Vertex> vertices, std::vector<Edge> edges)
    : vertices_(std::move(vertices)),
      edges_(std::move(edges)),
      firstOut_(vertices_.size() + 1),
      out_(2 * edges_.size()) {
  for (const Edge& edge : edges_) {
    ++firstOut_[edge.source.index() + 1];
    ++firstOut_[edge.target.index() + 1];
  }
  for (std::size_t v = 0; v < vertices_.size(); ++v) firstOut_[v + 1] += firstOut_[v];
  auto next = firstOut_;
  for (std::size_t h = 0; h < out_.size(); ++h)
    out_[next[source(HalfEdgeId(h)).index()]++] = HalfEdgeId(h);
}

Path TopologyGraph::halfPath(HalfEdgeId h) const {
  return runsAsPath(h) ? edge(h).path : reversed(edge(h).path);
}

TopologyGraph::HalfEdgeRange TopologyGraph::outgoing(VertexId v) const {
  return {out_.data() + firstOut_[v.index()], out_.data() + firstOut_[v.index() + 1]};
}

bool TopologyGraph::isDeadEnd(EdgeId e) const {
  return degree(edge(e).source) == 1 || degree(edge(e).target) == 1;
}

TopologyGraph keepOnly(TopologyGraph graph, const std::vector<bool>& keepVertex,
                       const std::vector<bool>& keepEdge) {
  const std::vector<Vertex> oldVertices = graph.vertices();
  std::vector<Edge> oldEdges = std::move(graph).takeEdges();
  std::vector<VertexId> newId(oldVertices.size());
  std::vector<Vertex> vertices;
  for (std::size_t v = 0; v < oldVertices.size(); ++v) {
    if (!keepVertex[v]) continue;
    newId[v] = VertexId(vertices.size());
    vertices.push_back(oldVertices[v]);
  }
  std::vector<Edge> edges;
  for (std::size_t e = 0; e < oldEdges.size(); ++e) {
    if (!keepEdge[e]) continue;
    Edge& edge = oldEdges[e];
    edge.source = newId[edge.source.index()];
    edge.target = newId[edge.target.index()];
    edges.push_back(std::move(edge));
  }
  return {std::move(vertices), std::move(edges)};
}

TopologyGraph dissolveThrough(TopologyGraph graph) {
  const auto& vertices = graph.vertices();
  std::vector<Link> links;
  for (const Edge& edge : graph.edges())
    links.push_back({std::uint32_t(edge.source.index()), std::uint32_t(edge.target.index())});
  std::vector<bool> isNode(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) isNode[v] = !isThrough(graph, VertexId(v));
  if (vertices.empty()) return graph;
  const Point middle = middleOf(vertices);
  const Chains chains =
      findChains(vertices.size(), links, isNode, [&](std::uint32_t a, std::uint32_t b) {
        return vertexRank(vertices[a], middle) < vertexRank(vertices[b], middle);
      });
  std::vector<Edge> edges;
  for (std::size_t c = 0; c < chains.count(); ++c)
    edges.push_back(joinedEdge(graph, &chains.steps[chains.starts[c]],
                               chains.steps.data() + chains.starts[c + 1]));
  std::vector<Vertex> kept = std::move(graph).takeVertices();
  for (const auto v : chains.ringNodes) {
    isNode[v] = true;
    kept[v].kind = VertexKind::ring;
  }
  const std::size_t edgeCount = edges.size();
  TopologyGraph result = keepOnly(TopologyGraph(std::move(kept), std::move(edges)), isNode,
                                  std::vector<bool>(edgeCount, true));
  for (std::size_t v = 0; v < result.vertices().size(); ++v)
    setKind(result.vertex(VertexId(v)), result.degree(VertexId(v)));
  return result;
}

}  // namespace roomgraph
