#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/rooms/Room.h"
#include "roomgraph/voronoi/VoronoiGraph.h"

namespace roomgraph {

/** Which Voronoi vertices, and so which Delaunay faces, make up which region. */
struct Regions {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> regionOf;  ///< per Voronoi vertex; kNone where it is in no region
  std::uint32_t count = 0;
  /** Faces of one region are parted where less than this lies between them and an obstacle [m]. */
  double radius = 0;

  std::uint32_t of(std::uint32_t vertex) const {
    return vertex == VoronoiEdge::kNoVertex ? kNone : regionOf[vertex];
  }
};

/** The regions of the groups, numbered by their smallest vertex; `isMember(v)` tells which vertices
 *  are in one at all. O(n). */
template <class IsMember>
Regions numbered(UnionFind& groups, const IsMember& isMember, std::size_t vertexCount,
                 double radius) {
  Regions regions{std::vector<std::uint32_t>(vertexCount, Regions::kNone), 0, radius};
  for (std::uint32_t v = 0; v < vertexCount; ++v) {
    if (!isMember(v)) continue;
    const std::uint32_t first = groups.find(v);
    if (regions.regionOf[first] == Regions::kNone) regions.regionOf[first] = regions.count++;
    regions.regionOf[v] = regions.regionOf[first];
  }
  return regions;
}

/** One room per region, with the union of its Delaunay faces as polygon. Rings that touch
 *  themselves are cut there; what encloses no area is dropped. O(n log n) in the number of Delaunay
 *  edges on the boundaries. */
Rooms traceRooms(const VoronoiGraph& voronoi, const Regions& regions);

}  // namespace roomgraph
