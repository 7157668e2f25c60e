#pragma once
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/rooms/Regions.h"
#include "roomgraph/voronoi/keep_inside.h"

namespace roomgraph {

/** What of the inside is no gap between neighbouring cells of a wall. O(n). */
inline InsideFlags clearInside(const VoronoiGraph& voronoi, InsideFlags isInside,
                               double minClearance) {
  for (std::size_t v = 0; v < isInside.size(); ++v)
    if (voronoi.vertices[v].clearance < minClearance) isInside[v] = 0;
  return isInside;
}

enum class RegionKind : std::uint8_t { room, corridor, halfSeen };

/** The groups of vertices inside as regions: first the rooms, then the corridors, then what is half
 *  seen, each by its smallest vertex. `kindOf(v)` is asked for the smallest vertex of each group.
 *  O(n). */
template <class KindOf>
Regions numberRegions(UnionFind& groups, const InsideFlags& isInside, const KindOf& kindOf,
                      double radius) {
  Regions regions;
  regions.regionOf.assign(isInside.size(), Regions::kNone);
  regions.radius = radius;
  const auto number = [&](RegionKind kind) {
    for (std::uint32_t v = 0; v < isInside.size(); ++v)
      if (isInside[v] && groups.find(v) == v && kindOf(v) == kind)
        regions.regionOf[v] = regions.count++;
    return regions.count;
  };
  regions.roomCount = number(RegionKind::room);
  regions.seenCount = number(RegionKind::corridor);
  number(RegionKind::halfSeen);
  for (std::uint32_t v = 0; v < isInside.size(); ++v)
    if (isInside[v]) regions.regionOf[v] = regions.regionOf[groups.find(v)];
  return regions;
}

}  // namespace roomgraph
