#include "reached_regions.h"

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/rooms/RoomIndex.h"

namespace roomgraph {
namespace {

/** One region at least of each connected part of the graph. */
std::vector<std::uint32_t> seeds(const Rooms& traced, const RoomGraph& graph) {
  const auto& vertices = graph.graph.vertices();
  UnionFind parts(vertices.size());
  for (const Edge& edge : graph.graph.edges())
    parts.join(std::uint32_t(edge.source.index()), std::uint32_t(edge.target.index()));
  std::vector<std::uint8_t> isFound(vertices.size());
  std::vector<std::uint32_t> found;
  for (const GraphRoom& room : graph.rooms) {
    found.push_back(room.shape.region);
    isFound[parts.find(std::uint32_t(room.vertex.index()))] = 1;
  }
  const RoomIndex index(traced, 0);
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    if (isFound[parts.find(v)]) continue;
    const RoomId region = index.roomAt(vertices[v].at);
    if (!region) continue;  // on a line between two, or beside clutter at the border
    found.push_back(std::uint32_t(region.index()));
    isFound[parts.find(v)] = 1;
  }
  return found;
}

}  // namespace

bool isPassage(const VoronoiEdge& edge, const Regions& regions, double clearance) {
  if (edge.isInfinite() || edge.minClearance < clearance) return false;
  const std::uint32_t a = regions.of(edge.source), b = regions.of(edge.target);
  return a != b && a != Regions::kNone && b != Regions::kNone;
}

std::vector<std::uint8_t> reachedRegions(const ClearedSpace& space, const Rooms& traced,
                                         const RoomGraph& graph, double clearance) {
  const Regions& regions = space.regions;
  std::vector<std::uint8_t> isOpen(regions.count, 1);
  for (std::uint32_t r = 0; r < regions.roomCount; ++r) isOpen[r] = 0;
  for (const GraphRoom& room : graph.rooms) isOpen[room.shape.region] = 1;

  UnionFind parts(regions.count);
  for (const VoronoiEdge& edge : space.voronoi.edges) {
    if (!isPassage(edge, regions, clearance)) continue;
    const std::uint32_t a = regions.of(edge.source), b = regions.of(edge.target);
    if (isOpen[a] && isOpen[b]) parts.join(a, b);
  }
  std::vector<std::uint8_t> isReachedPart(regions.count), isReached(regions.count);
  for (const std::uint32_t region : seeds(traced, graph)) isReachedPart[parts.find(region)] = 1;
  for (std::uint32_t r = 0; r < regions.count; ++r)
    isReached[r] = isOpen[r] && isReachedPart[parts.find(r)];
  return isReached;
}

}  // namespace roomgraph
