#pragma once
#include "roomgraph/grid/Grid.h"
#include "roomgraph/rooms/Regions.h"
#include "roomgraph/rooms/Room.h"
#include "roomgraph/topology/keep_inside.h"

namespace roomgraph {

// In:   the map without clutter with its VoronoiGraph and Regions, and its walls
// Out:  RegionOutlines; the diagram is not needed any more
// Next: borderVertices (the rooms), areaGraph

/** A Delaunay edge between two regions, or between a region and the outside. */
struct RegionBorder {
  std::uint32_t left, right;  ///< the regions on both sides of the way; Regions::kNone for outside
  Point from, to;             ///< two obstacles [m, map frame]
  double clearance = 0;       ///< of the way across [m]; 0 where there is none
  int wallEnds = 2;           ///< how many of the two obstacles are wall
};

/** The regions by their borders. */
struct RegionOutlines {
  Rooms regions;                      ///< the shape of each, rooms first
  std::uint32_t roomCount = 0;        ///< how many of them are rooms
  std::uint32_t seenCount = 0;        ///< how many are rooms or corridors; the others are half seen
  std::vector<RegionBorder> borders;  ///< ordered as the diagram's edges

  [[nodiscard]] Rooms rooms() const { return {regions.begin(), regions.begin() + roomCount}; }
  [[nodiscard]] Rooms halfSeen() const { return {regions.begin() + seenCount, regions.end()}; }
  /** The rooms, and the corridors that are no smaller than the median room: smaller ones are what
   *  furniture and broken walls leave. */
  [[nodiscard]] Rooms worthAWay() const;
};

/** Traces the regions. Delaunay faces of the inside that are in no region, because their centre
 *  lies in a wall or in the unknown, count to the region that they are open to for `borders`, so
 *  that these part all free cells; the shapes leave them out. `isWall`, per obstacle, tells walls
 *  from the edge of the unknown. O(n log n). */
[[nodiscard]] RegionOutlines regionOutlines(const Grid& grid, const VoronoiGraph& voronoi,
                                            const InsideFlags& isInside, const Regions& regions,
                                            const std::vector<std::uint8_t>& isWall);

}  // namespace roomgraph
