#include "roomgraph/topology/topology_graph.h"

#include "roomgraph/base/sequences.h"
#include "roomgraph/topology/chains.h"
#include "vertex_rank.h"

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
    return voronoi.vertices[s.isForward ? edge.source : edge.target].place;
  };
  const auto endOf = [&](Step s) { return startOf({s.link, !s.isForward}); };
  Polyline points;
  std::vector<Point> obstacles;
  points.reserve(std::size_t(last - first) + 1);
  obstacles.reserve(std::size_t(last - first));
  points.push_back(startOf(*first));
  for (const Step* step = first; step != last; ++step) {
    points.push_back(endOf(*step));
    obstacles.push_back(voronoi.obstacles[voronoi.edges[kept[step->link]].left]);
  }
  return makePath(std::move(points), std::move(obstacles));
}

std::vector<Link> linksOf(const VoronoiGraph& voronoi, const EdgeIndices& kept,
                          const Renumbering& numbers) {
  std::vector<Link> links;
  links.reserve(kept.size());
  for (const auto e : kept)
    links.push_back(
        {numbers.newOf[voronoi.edges[e].source], numbers.newOf[voronoi.edges[e].target]});
  return links;
}

std::vector<std::uint32_t> degreesOf(const std::vector<Link>& links, std::size_t vertexCount) {
  std::vector<std::uint32_t> degrees(vertexCount);
  for (const Link& link : links) {
    ++degrees[link.source];
    ++degrees[link.target];
  }
  return degrees;
}

VertexKind kindOf(std::uint32_t degree) {
  if (degree == 1) return VertexKind::deadEnd;
  return degree == 2 ? VertexKind::ring : VertexKind::junction;
}

}  // namespace

TopologyGraph topologyGraph(const VoronoiGraph& voronoi, const EdgeIndices& kept) {
  const Renumbering numbers = renumber(voronoi, kept);
  const std::vector<Link> links = linksOf(voronoi, kept, numbers);
  const std::vector<std::uint32_t> degrees = degreesOf(links, numbers.oldOf.size());
  std::vector<bool> isNode(degrees.size());
  for (std::size_t v = 0; v < degrees.size(); ++v) isNode[v] = degrees[v] != 2;
  const auto vertexOf = [&](std::uint32_t v) { return voronoi.vertices[numbers.oldOf[v]]; };
  if (degrees.empty()) return {};
  const Point middle =
      middleOf(mapped(numbers.oldOf, [&](std::uint32_t v) { return voronoi.vertices[v]; }));
  const auto isWider = [&](std::uint32_t a, std::uint32_t b) {
    return vertexRank(vertexOf(a), middle) < vertexRank(vertexOf(b), middle);
  };
  const Chains chains = findChains(degrees.size(), links, isNode, isWider);
  for (const auto v : chains.ringNodes) isNode[v] = true;

  std::vector<VertexId> idOf(degrees.size());
  std::vector<Vertex> vertices;
  for (std::uint32_t v = 0; v < degrees.size(); ++v) {
    if (!isNode[v]) continue;
    idOf[v] = VertexId(vertices.size());
    vertices.push_back(
        {vertexOf(v).place, vertexOf(v).clearance, kindOf(degrees[v]), RoomId::none()});
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
