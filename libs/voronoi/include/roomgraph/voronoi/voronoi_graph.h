#pragma once
#include "roomgraph/grid/obstacle_sites.h"
#include "roomgraph/voronoi/VoronoiGraph.h"

namespace roomgraph {

// Paper III-A, first half
// In:   ObstacleSites
// Out:  VoronoiGraph
// Next: keepInside

/** The Voronoi diagram of the cell centres (Boost.Polygon). The order of vertices and edges depends
 *  on the cells alone. Fewer than two sites give no edge. O(n log n). */
VoronoiGraph voronoiGraph(const ObstacleSites& sites);

}  // namespace roomgraph
