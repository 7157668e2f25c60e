#include "roomgraph/topology/topology_graph.h"

#include "roomgraph/topology/chains.h"

namespace roomgraph {
namespace {

/** The Voronoi vertices at the ends of kept edges, numbered anew without gaps. */
struct Renumbering {
  std::vector<std::uint32_t> newOf, oldOf;
};

Renumbering renumber(const VoronoiGraph& voronoi, const EdgeIndices& kept) {
  std::vector<std::uint32_t> newOf(voronoi.vertices.size(), VoronoiEdge::kNoVertex);
  for (const auto e : kept) newOf[voronoi.edges[e].source] = newOf[voronoi.edges[e].target] = 0;
  std::vector<std::uint32_t> oldOf;
  for (std::uint32_t v = 0; v < newOf.size(); ++v) {
    if (newOf[v] == VoronoiEdge::kNoVertex) continue;
    newOf[v] = std::uint32_t(oldOf.size());
    oldOf.push_back(v);
  }
  return {std::move(newOf), std::move(oldOf)};
}

Path pathOf(const VoronoiGraph& voronoi, const EdgeIndices& kept, const Step* first,
            const Step* last) {
  const auto startOf = [&](Step s) {
    const VoronoiEdge& edge = voronoi.edges[kept[s.link]];
    return voronoi.vertices[s.isForward ? edge.source : edge.target].at;
  };
  const auto endOf = [&](Step s) { return startOf({s.link, !s.isForward}); };
  Polyline points;
  std::vector<Point> obstacles;
  points.reserve(std::size_t(last - first) + 1);
  obstacles.reserve(std::size_t(last - first));
  points.push_back(startOf(*first));
  for (const Step* step = first; step != last; ++step) {
    points.push_back(endOf(*step));
    obstacles.push_back(voronoi.sites[voronoi.edges[kept[step->link]].left]);
  }
  return makePath(std::move(points), std::move(obstacles));
}

}  // namespace

TopologyGraph topologyGraph(const VoronoiGraph& voronoi, const EdgeIndices& kept) {
  const Renumbering numbers = renumber(voronoi, kept);
  std::vector<Link> links;
  links.reserve(kept.size());
  std::vector<std::uint32_t> degree(numbers.oldOf.size());
  for (const auto e : kept) {
    const VoronoiEdge& edge = voronoi.edges[e];
    links.push_back({numbers.newOf[edge.source], numbers.newOf[edge.target]});
    ++degree[links.back().source];
    ++degree[links.back().target];
  }
  std::vector<bool> isNode(degree.size());
  for (std::size_t v = 0; v < degree.size(); ++v) isNode[v] = degree[v] != 2;
  const auto vertexOf = [&](std::uint32_t v) { return voronoi.vertices[numbers.oldOf[v]]; };
  const Chains chains =
      findChains(degree.size(), links, isNode, [&](std::uint32_t a, std::uint32_t b) {
        const VoronoiVertex va = vertexOf(a), vb = vertexOf(b);
        return va.clearance > vb.clearance || (va.clearance == vb.clearance && va.at < vb.at);
      });
  for (const auto v : chains.ringNodes) isNode[v] = true;

  std::vector<VertexId> idOf(degree.size());
  std::vector<Vertex> vertices;
  for (std::uint32_t v = 0; v < degree.size(); ++v) {
    if (!isNode[v]) continue;
    idOf[v] = VertexId(vertices.size());
    const VertexKind kind = degree[v] == 1   ? VertexKind::deadEnd
                            : degree[v] == 2 ? VertexKind::ring
                                             : VertexKind::junction;
    vertices.push_back({vertexOf(v).at, vertexOf(v).clearance, kind, RoomId::none()});
  }
  std::vector<Edge> edges;
  edges.reserve(chains.count());
  for (std::size_t c = 0; c < chains.count(); ++c) {
    const Step* first = chains.steps.data() + chains.starts[c];
    const Step* last = chains.steps.data() + chains.starts[c + 1];
    const Step end = *(last - 1);
    const auto from = first->isForward ? links[first->link].source : links[first->link].target;
    const auto to = end.isForward ? links[end.link].target : links[end.link].source;
    edges.push_back({idOf[from], idOf[to], pathOf(voronoi, kept, first, last), RoomId::none()});
  }
  return {std::move(vertices), std::move(edges)};
}

}  // namespace roomgraph
