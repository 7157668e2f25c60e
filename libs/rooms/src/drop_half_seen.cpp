#include "roomgraph/rooms/drop_half_seen.h"

#include "roomgraph/rooms/RoomIndex.h"

namespace roomgraph {

InsideFlags dropHalfSeen(const VoronoiGraph& voronoi, InsideFlags isInside,
                         const RegionOutlines& outlines) {
  const Rooms halfSeen = outlines.halfSeen();
  if (halfSeen.empty()) return isInside;
  const RoomIndex index(halfSeen);
  for (std::size_t v = 0; v < isInside.size(); ++v)
    if (isInside[v] && index.roomAt(voronoi.vertices[v].place)) isInside[v] = 0;
  return isInside;
}

}  // namespace roomgraph
