#include "roomgraph/rooms/drop_half_seen.h"

#include "roomgraph/base/sequences.h"
#include "roomgraph/rooms/RoomIndex.h"

namespace roomgraph {

EdgeIndices dropHalfSeen(const VoronoiGraph& voronoi, EdgeIndices edges,
                         const RegionOutlines& outlines) {
  const RoomIndex halfSeen(outlines.halfSeen());
  const auto isHalfSeen = [&](std::uint32_t v) {
    return bool(halfSeen.roomAt(voronoi.vertices[v].place));
  };
  eraseIf(edges, [&](std::uint32_t e) {
    return isHalfSeen(voronoi.edges[e].source) || isHalfSeen(voronoi.edges[e].target);
  });
  return edges;
}

}  // namespace roomgraph
