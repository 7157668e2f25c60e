#pragma once
#include <algorithm>
#include <vector>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/rooms/Regions.h"
#include "roomgraph/topology/keep_inside.h"

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
 *  seen, each kind from the largest to the smallest, so that a region has the same number however
 *  the map is turned. `kindOf(v)` and `areaOf(v)` are asked for the smallest vertex of each group.
 *  O(n), and O(r log r) in the regions. */
template <class KindOf, class AreaOf>
Regions numberRegions(UnionFind& groups, const InsideFlags& isInside, const KindOf& kindOf,
                      const AreaOf& areaOf, double radius) {
  Regions regions;
  regions.regionOf.assign(isInside.size(), Regions::kNone);
  regions.radius = radius;
  const auto number = [&](RegionKind kind) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t v = 0; v < isInside.size(); ++v)
      if (isInside[v] && groups.find(v) == v && kindOf(v) == kind) found.push_back(v);
    std::stable_sort(found.begin(), found.end(),
                     [&](std::uint32_t l, std::uint32_t r) { return areaOf(l) > areaOf(r); });
    for (const std::uint32_t v : found) regions.regionOf[v] = regions.count++;
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
