#include "roomgraph/rooms/drop_half_seen.h"

#include <algorithm>

#include "roomgraph/rooms/RoomIndex.h"

namespace roomgraph {

EdgeIndices dropHalfSeen(const VoronoiGraph& voronoi, EdgeIndices edges,
                         const RegionOutlines& outlines) {
  const RoomIndex halfSeen(outlines.halfSeen());
  const auto isHalfSeen = [&](std::uint32_t v) {
    return bool(halfSeen.roomAt(voronoi.vertices[v].place));
  };
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [&](std::uint32_t e) {
                               const VoronoiEdge& edge = voronoi.edges[e];
                               return isHalfSeen(edge.source) || isHalfSeen(edge.target);
                             }),
              edges.end());
  return edges;
}

}  // namespace roomgraph
