#pragma once
#include "roomgraph/rooms/region_outlines.h"
#include "roomgraph/topology/keep_clear.h"

namespace roomgraph {

// In:   VoronoiGraph of the whole map, its clear edges, and the RegionOutlines
// Out:  the edges without those of half-seen space
// Next: topologyGraph

/** Drops all edges that touch half-seen regions, so that no path leads into a fan of beams.
 *  O(edges). */
[[nodiscard]] EdgeIndices dropHalfSeen(const VoronoiGraph& voronoi, EdgeIndices edges,
                                       const RegionOutlines& outlines);

}  // namespace roomgraph
