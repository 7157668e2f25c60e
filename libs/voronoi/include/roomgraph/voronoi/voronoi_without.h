#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/grid/obstacle_sites.h"
#include "roomgraph/voronoi/VoronoiGraph.h"

namespace roomgraph {

// Ours: the diagram without clutter, at the price of the clutter alone
// In:   VoronoiGraph, and which of its sites to leave out
// Out:  VoronoiGraph
// Next: keepInside, splitAtDoors

/** The Voronoi diagram of the sites that are not flagged. Only the holes that the others leave in
 *  the Delaunay triangulation are filled anew, each from the sites round it: a face that is empty
 *  of all sites is empty of these, too. `graph` must be voronoiGraph(sites). The sites keep their
 *  numbers; the flagged ones stay in `sites` and belong to no edge. O(n + h log h) for h sites
 *  round the holes. */
VoronoiGraph voronoiWithout(const VoronoiGraph& graph, const ObstacleSites& sites,
                            const std::vector<std::uint8_t>& isLeftOut);

}  // namespace roomgraph
