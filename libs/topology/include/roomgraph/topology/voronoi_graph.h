#pragma once
#include "roomgraph/grid/obstacle_cells.h"
#include "roomgraph/topology/VoronoiGraph.h"

namespace roomgraph {

// Paper III-A, first half
// In:   ObstacleCells
// Out:  VoronoiGraph
// Next: keepInside

/** The Voronoi diagram of the cell centres (Boost.Polygon). The order of vertices and edges depends
 *  on the cells alone. Fewer than two obstacles give no edge. O(n log n). */
[[nodiscard]] VoronoiGraph voronoiGraph(const ObstacleCells& obstacles);

}  // namespace roomgraph
