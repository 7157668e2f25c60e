#pragma once
#include "roomgraph/rooms/Regions.h"
#include "roomgraph/rooms/Room.h"

namespace roomgraph {

// Paper III-B: the polygons of the rooms
// In:   VoronoiGraph and its Regions
// Out:  Rooms, and the other regions after them
// Next: borderVertices

/** One room per region, pieces of corridor too, with the union of its Delaunay faces as polygon.
 *  Rings that touch themselves are cut there; what encloses no area is dropped. O(n log n) in the
 *  number of Delaunay edges on the boundaries. */
[[nodiscard]] Rooms traceRegions(const VoronoiGraph& voronoi, const Regions& regions);

}  // namespace roomgraph
