#pragma once
#include "roomgraph/rooms/region_outlines.h"
#include "roomgraph/topology/keep_inside.h"

namespace roomgraph {

// Ours
// In:   VoronoiGraph of the whole map, what of it lies inside, and the RegionOutlines
// Out:  the flags without half-seen space
// Next: keepClear

/** Clears the flags of all vertices in half-seen regions, so that no path leads into a fan of
 *  beams. O(n). */
[[nodiscard]] InsideFlags dropHalfSeen(const VoronoiGraph& voronoi, InsideFlags isInside,
                                       const RegionOutlines& outlines);

}  // namespace roomgraph
