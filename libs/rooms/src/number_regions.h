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

/** The groups of vertices inside as regions: first the rooms, then the others, each by its smallest
 *  vertex. `isRoom(v)` is asked for the smallest vertex of each group. O(n). */
template <class IsRoom>
Regions numberRegions(UnionFind& groups, const InsideFlags& isInside, const IsRoom& isRoom,
                      double radius) {
  Regions regions;
  regions.regionOf.assign(isInside.size(), Regions::kNone);
  regions.radius = radius;
  const auto number = [&](bool areRooms) {
    for (std::uint32_t v = 0; v < isInside.size(); ++v)
      if (isInside[v] && groups.find(v) == v && isRoom(v) == areRooms)
        regions.regionOf[v] = regions.count++;
  };
  number(true);
  regions.roomCount = regions.count;
  number(false);
  for (std::uint32_t v = 0; v < isInside.size(); ++v)
    if (isInside[v]) regions.regionOf[v] = regions.regionOf[groups.find(v)];
  return regions;
}

}  // namespace roomgraph
