#pragma once
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/PointSums.h"
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

/** Per group, by its smallest vertex, how far from the middle of the map it begins [m2]. O(n). */
inline std::vector<float> nearestToMiddle(const VoronoiGraph& voronoi, UnionFind& groups,
                                          const InsideFlags& isInside) {
  PointSums all;
  for (std::size_t v = 0; v < isInside.size(); ++v)
    if (isInside[v]) all.add(voronoi.vertices[v].place);
  const Point middle = all.mean();
  std::vector<float> nearest(isInside.size(), std::numeric_limits<float>::max());
  for (std::uint32_t v = 0; v < isInside.size(); ++v) {
    if (!isInside[v]) continue;
    float& least = nearest[groups.find(v)];
    least = std::min(least, float(squaredNorm(voronoi.vertices[v].place - middle)));
  }
  return nearest;
}

/** The groups of vertices inside as regions: first the rooms, then the corridors, then what is half
 *  seen, each kind from the largest to the smallest, and of equal ones from the middle of the map
 *  outwards, so that a region has the same number however the map is turned. What rounding changes
 *  is no difference. `kindOf(v)` and `areaOf(v)` are asked for the smallest vertex of each group.
 *  O(n), and O(r log r) in the regions. */
template <class KindOf, class AreaOf>
Regions numberRegions(const VoronoiGraph& voronoi, UnionFind& groups, const InsideFlags& isInside,
                      const KindOf& kindOf, const AreaOf& areaOf, double radius) {
  Regions regions;
  regions.regionOf.assign(isInside.size(), Regions::kNone);
  regions.radius = radius;
  const std::vector<float> nearest = nearestToMiddle(voronoi, groups, isInside);
  const auto number = [&](RegionKind kind) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t v = 0; v < isInside.size(); ++v)
      if (isInside[v] && groups.find(v) == v && kindOf(v) == kind) found.push_back(v);
    sortBy(found, [&](std::uint32_t v) { return std::make_pair(-float(areaOf(v)), nearest[v]); });
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
